#pragma once

#include <cstdint>
#include <span>

namespace thiessen {

/// How many metres a foot is.
inline constexpr double metres_in_foot = 0.3048;

/// Whose elevations are in feet where the others are in metres.
enum class InFeet : std::uint8_t { nobody, stations, raster };

/// Tells by the median ratio of stations' elevations to those of a raster at the same places
/// whether the ones are in feet and the others in metres: 3.28 or its inverse, to a tenth. NaN
/// where one is not known. Only places where both are above 30 count, and three at least: a lower
/// one differs by more than a tenth for a valley's side that falls into one pixel.
InFeet judge_feet(std::span<const double> of_stations, std::span<const double> of_raster);

}  // namespace thiessen
