#pragma once

#include <array>

#include "geometry/point.h"

namespace thiessen {

/// The point at a share of the way.
constexpr Point between(Point from, Point to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

/// Where along a segment to look at what a curve is off it, and how much each counts in the mean,
/// for a curve that meets it at both ends (G. Boole's rule).
struct BooleSample {
  double along;
  double weight;
};
inline constexpr std::array<BooleSample, 3> boole_samples{
    {{0.25, 32. / 90}, {0.5, 12. / 90}, {0.75, 32. / 90}}};

}  // namespace thiessen
