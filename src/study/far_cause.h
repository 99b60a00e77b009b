#pragma once

#include <functional>
#include <vector>

#include "base/wording.h"
#include "geometry/point.h"

namespace thiessen {

/// A mistake that may be why gauges and basins are nowhere near each other. It is the likely cause
/// where they would meet without it.
struct FarCause {
  using Correction = std::function<std::vector<Point>(std::vector<Point>)>;

  Wording text;       ///< how they would meet: `latitude and longitude swapped`
  Correction gauges;  ///< where the gauges would then be; empty: where they are
  Correction basins;  ///< where the corners of the basins would then be; empty: where they are
};

/// The mistakes that can be told from coordinates alone: swapped order, wrong signs, and in a plane
/// kilometres for metres. `on_earth`: the coordinates are longitude and latitude.
std::vector<FarCause> far_causes_of_coordinates(bool on_earth);

}  // namespace thiessen
