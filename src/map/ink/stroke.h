#pragma once

#include <span>

#include "geometry/point.h"
#include "map/ink/canvas.h"

namespace thiessen {

/// Covers a line of the given width (pixels) with smooth edges and round ends. A pixel keeps the
/// largest coverage that any line gives it, so that an edge drawn twice looks like one.
/// Parts outside `layer` are left out; coordinates must be finite. Cost: the pixels covered.
void stroke(Coverage& layer, Point from, Point to, double line_width);

/// Strokes the line through `points`, passing over vertices closer than a third of a pixel.
void stroke(Coverage& layer, std::span<const Point> points, double line_width);

}  // namespace thiessen
