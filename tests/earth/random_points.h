#pragma once

#include <cmath>

#include "earth/geodesic.h"
#include "geometry/seeded.h"

namespace thiessen {

/// Anywhere on the Earth.
inline Point random_point(Seeded& seeded) {
  return {seeded.uniform(-180, 180), std::asin(seeded.uniform(-1, 1)) * 180 / M_PI};
}

/// So many metres from p, any way.
inline Point random_point_at(Seeded& seeded, Point p, double metres) {
  const double angle = seeded.uniform(0, 2 * M_PI);
  return moved(p, metres * std::sin(angle), metres * std::cos(angle));
}

}  // namespace thiessen
