#pragma once

#include <GeographicLib/Geodesic.hpp>
#include <cmath>

#include "geometry/point.h"
#include "geometry/seeded.h"

namespace thiessen {

/// Anywhere on the Earth.
inline Point random_point(Seeded& seeded) {
  return {seeded.uniform(-180, 180), std::asin(seeded.uniform(-1, 1)) * 180 / M_PI};
}

/// The point reached by going straight, metres east and north at the start.
inline Point moved(Point start, double east, double north) {
  Point end;
  GeographicLib::Geodesic::WGS84().Direct(start.y, start.x, std::atan2(east, north) * 180 / M_PI,
                                          std::hypot(east, north), end.y, end.x);
  return end;
}

/// So many metres from p, any way.
inline Point random_point_at(Seeded& seeded, Point p, double metres) {
  const double angle = seeded.uniform(0, 2 * M_PI);
  return moved(p, metres * std::sin(angle), metres * std::cos(angle));
}

}  // namespace thiessen
