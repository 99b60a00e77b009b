#pragma once

#include <numbers>

namespace thiessen {

/// In radians.
inline constexpr double degree = std::numbers::pi / 180;
/// The Earth's mean radius in metres: for what may be half a per cent off.
inline constexpr double mean_radius = 6371008.8;

}  // namespace thiessen
