#pragma once

#include <numbers>

namespace thiessen {

/// One degree in radians.
inline constexpr double degree = std::numbers::pi / 180;
/// The Earth's mean radius in metres, for figures that may be half a per cent off.
inline constexpr double mean_radius = 6371008.8;

}  // namespace thiessen
