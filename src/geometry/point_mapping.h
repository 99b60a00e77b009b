#pragma once

#include <functional>
#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// Transforms points from one coordinate system to another, in place. A point that cannot be
/// transformed becomes NaN. A mapping may keep state, so each thread needs its own.
using PointMapping = std::function<void(std::vector<Point>&)>;

}  // namespace thiessen
