#pragma once

#include <opencv2/core.hpp>
#include <span>

#include "map/ink/canvas.h"

namespace thiessen {

/// Fills areas in `pixels`, whose upper left has the coordinates `corner`. A pixel gets the mean of
/// a finer grid, on which each area takes the pixels that its inside or its outline touches, the
/// later area before the earlier. Memory does not grow with the pixels. Cost: the vertices, and the
/// pixels of the finer grid. Stops with Interrupted where a signal came.
void fill_areas(const cv::Mat& pixels, Point corner, std::span<const Area> areas,
                const Hatch& hatch);

}  // namespace thiessen
