#pragma once

#include <optional>

#include "map/opencv/pixel_canvas.h"
#include "map/plot/tessellation_picture.h"

namespace thiessen {

/// Draws the picture of a tessellation in space; see space_picture.
PixelCanvas view_space(const Tessellation<3>& tessellation, const NumberOf& number_of,
                       const std::optional<View>& view, const PlotSize& size = {});

}  // namespace thiessen
