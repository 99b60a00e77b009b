#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "geometry/point.h"

namespace thiessen {

/// The coordinates of a position, x first, or as many numbers of another kind.
template <int Dimension, typename Number = double>
using CoordinatesIn = std::array<Number, std::size_t{Dimension}>;

/// The names of the axes, in the order of the coordinates.
inline constexpr std::array<std::string_view, 3> axis_names = {"x", "y", "z"};

/// The coordinates of a position by number, for code that is written once for every dimension.
inline CoordinatesIn<2> coordinates(const Point& p) {
  return {p.x, p.y};
}
inline CoordinatesIn<3> coordinates(const SpacePoint& p) {
  return {p.x, p.y, p.z};
}

/// The square of the distance between a and b, computed in doubles and rounded.
template <std::size_t Axes>
double square_distance(const std::array<double, Axes>& a, const std::array<double, Axes>& b) {
  double sum = 0;
  for (std::size_t axis = 0; axis < Axes; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return sum;
}

}  // namespace thiessen
