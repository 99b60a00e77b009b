#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// For each point the number of the first one that is equal to it, which is its own if none before
/// it is. Points are equal as `==` has it, so 0 and -0 are; requires that no coordinate is NaN.
/// Cost: in proportion to the points, wherever they are. Memory: 8 to 16 bytes a point beside the
/// result.
std::vector<std::uint32_t> first_equal_points(std::span<const Point> points);

}  // namespace thiessen
