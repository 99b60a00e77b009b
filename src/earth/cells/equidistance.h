#pragma once

#include <array>
#include <optional>

#include "earth/sphere/geodesic.h"

namespace thiessen {

/// A point at equal geodesic distance, `radius` in metres, of three places.
struct Equidistant {
  Direction at;  ///< on the conformal sphere
  double radius;
};

/// The point at equal geodesic distance of three places that lies near `start`, found by Newton's
/// method until the distances agree to `accuracy` metres, at least 1e-7. The result is empty where
/// it is not found: near the antipode of places that are near each other distances hardly differ,
/// and may be equal at no point or at several. Cost: three geodesics for each of one to three
/// steps.
std::optional<Equidistant> equidistant_point(const EarthPoint& a, const EarthPoint& b,
                                             const EarthPoint& c, Direction start, double accuracy);
/// The same, where the sphere's scale at each place is known.
std::optional<Equidistant> equidistant_point(const std::array<EarthPoint, 3>& places,
                                             const std::array<double, 3>& scales, Direction start,
                                             double accuracy);

}  // namespace thiessen
