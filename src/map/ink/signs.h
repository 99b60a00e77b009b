#pragma once

#include <cstddef>

#include "map/ink/canvas.h"

namespace thiessen {

/// The width of a cell's or a basin's outline on the map, and of an isohyet, in pixels.
double cell_line_width(int em);
double basin_line_width(int em);
double isohyet_line_width(int em);

/// The line round a cell on ground of this colour, where there is ample room: dark, or on dark
/// ground light, whichever is told from the ground more easily.
Stroke cell_stroke(int em, Colour ground);

/// The light rim by which a basin's outline of this width stands out from dark ground.
Stroke basin_rim(int em, double width);

/// Whether a basin's outline is lost on ground of this colour without a rim.
bool hides_basin_edge(Colour ground);

/// The radius in pixels of a gauge's dot where `gauges` dots share `pixels` of the map: smaller
/// where they crowd.
double gauge_radius(int em, std::size_t gauges, double pixels);

/// The distance from the middle of a dot of this radius to the rim of its white ring.
double gauge_reach(double radius);

/// Draws a gauge as a red dot in a white ring, hollow where the gauge is silent. Only pixels inside
/// `clip` change. The dot has the mark.
void draw_gauge(Canvas& canvas, Point centre, double radius, bool reports, const PixelBox& clip,
                const Mark& mark = {});

}  // namespace thiessen
