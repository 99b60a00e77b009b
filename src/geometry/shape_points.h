#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/polygon.h"

namespace thiessen {

/// Whether every point of a shape, of its outer rings and of its holes, is as `is_so` asks. The
/// points are asked in their order, until one is not.
template <typename IsSo>
bool every_point(const MultiPolygon& shape, IsSo is_so) {
  const auto ring = [&](const Ring& points) {
    return std::all_of(points.begin(), points.end(), [&](Point point) { return is_so(point); });
  };
  return std::all_of(shape.begin(), shape.end(), [&](const Polygon& polygon) {
    return ring(polygon.outer) && std::all_of(polygon.holes.begin(), polygon.holes.end(), ring);
  });
}

/// Whether no coordinate is infinite or not a number.
inline bool is_finite(Point point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

}  // namespace thiessen
