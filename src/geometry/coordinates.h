#pragma once

#include <array>
#include <cstddef>

#include "geometry/point.h"

namespace thiessen {

/// A position's coordinates, x first, or as many numbers of another kind.
template <int Dimension, typename Number = double>
using CoordinatesIn = std::array<Number, std::size_t{Dimension}>;

/// A position's coordinates by number, for what is written once for every dimension.
inline CoordinatesIn<2> coordinates(const Point& p) {
  return {p.x, p.y};
}
inline CoordinatesIn<3> coordinates(const SpacePoint& p) {
  return {p.x, p.y, p.z};
}

}  // namespace thiessen
