#pragma once

#include <optional>

#include "map/ink/canvas.h"
#include "map/plot/tessellation_picture.h"

namespace thiessen {

/// Draws the picture of a tessellation in space; see space_picture.
Canvas view_space(const Tessellation<3>& tessellation, const NumberOf& number_of,
                  const std::optional<View>& view);

}  // namespace thiessen
