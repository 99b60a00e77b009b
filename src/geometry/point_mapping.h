#pragma once

#include <functional>
#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// Takes points from one system of coordinates to another, in place; NaN where that cannot be. May
/// keep state: one for a thread.
using PointMapping = std::function<void(std::vector<Point>&)>;

}  // namespace thiessen
