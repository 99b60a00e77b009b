#pragma once

#include <cstddef>

#include "map/ink/canvas.h"

namespace thiessen {

/// Line widths of the map, in pixels.
double cell_line_width(int em);
double basin_line_width(int em);

/// A gauge's dot: the radius of `gauges` dots that share `pixels` of map, smaller where they crowd.
double gauge_radius(int em, std::size_t gauges, double pixels);

/// From the middle of a dot of this radius to the rim of its white ring.
double gauge_reach(double radius);

/// A red dot in a white ring; hollow where the gauge is silent. Only pixels of `clip` change.
void draw_gauge(Canvas& canvas, Point centre, double radius, bool reports, const PixelBox& clip);

}  // namespace thiessen
