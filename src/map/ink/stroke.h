#pragma once

#include <span>

#include "geometry/point.h"
#include "map/ink/canvas.h"

namespace thiessen {

/// Adds a line of the given width (pixels) with smooth edges and round ends to the coverage. A
/// pixel keeps the largest coverage that any line gives it, so that an edge drawn twice looks like
/// one. Parts outside `layer` are left out; coordinates must be finite. Cost: the pixels covered.
void stroke(Coverage& layer, Point from, Point to, double line_width);

/// Strokes the line through `points`. Vertices closer together than a third of a pixel are passed
/// over.
void stroke(Coverage& layer, std::span<const Point> points, double line_width);

}  // namespace thiessen
