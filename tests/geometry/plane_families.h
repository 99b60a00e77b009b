#pragma once

#include <array>
#include <cmath>

#include "geometry/point.h"
#include "geometry/seeded.h"

namespace thiessen {

using Corners = std::array<Point, 4>;

inline double random_magnitude(Seeded& seeded, int low, int high) {
  const double mantissa = seeded.uniform(1, 2);
  const double sign = seeded.below(2) == 0 ? 1 : -1;
  return sign * std::ldexp(mantissa, static_cast<int>(seeded.whole(low, high)));
}

/// Four points: anywhere, nearly on a line or a circle, ulps apart, on a grid, on one in tenths, on
/// one of two scales, over the whole range.
inline Corners random_corners(Seeded& seeded) {
  Corners corners;
  const auto family = seeded.below(8);
  for (Point& p : corners) {
    const double t = seeded.uniform(0, 7);
    switch (family) {
      case 0:
        p = {seeded.uniform(-1, 1), seeded.uniform(-1, 1)};
        break;
      case 1:
        p = {t, seeded.near(0.3 * t, 1)};
        break;
      case 2:
        p = {1e6 + std::cos(t), 4e6 + std::sin(t)};
        break;
      case 3:
        p = {seeded.near(0.5, 4), seeded.near(0.5, 4)};
        break;
      case 4:
        p = {static_cast<double>(seeded.whole(-3, 3)), static_cast<double>(seeded.whole(-3, 3))};
        break;
      case 5:
        p = {500000 + 0.1 * static_cast<double>(seeded.whole(-3, 3)),
             4000000 + 0.1 * static_cast<double>(seeded.whole(-3, 3))};
        break;
      case 6:
        p = {static_cast<double>(seeded.whole(-1, 1)),
             std::ldexp(static_cast<double>(seeded.whole(-1, 1)), -70)};
        break;
      default:
        p = {random_magnitude(seeded, -142, 200), random_magnitude(seeded, -142, 200)};
    }
  }
  return corners;
}

}  // namespace thiessen
