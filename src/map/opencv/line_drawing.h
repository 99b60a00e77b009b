#pragma once

#include <opencv2/core.hpp>
#include <span>

#include "map/ink/canvas.h"

namespace thiessen {

/// Draws lines in `pixels`, whose upper left has the coordinates `corner`. Their width is right to
/// a quarter of a pixel, or to four tenths where it is four pixels and more. Memory does not grow
/// with the pixels. Cost: the vertices, and the pixels of a finer grid over all that the lines
/// reach.
void draw_lines(const cv::Mat& pixels, Point corner, std::span<const Polyline> lines,
                const Stroke& stroke);

}  // namespace thiessen
