#pragma once

#include <compare>

namespace thiessen {

/// A position in a plane: easting and northing in a projection, or longitude and latitude in
/// degrees. The default order is lexicographic, x before y; the tessellation breaks its ties by it.
struct Point {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point&, const Point&) = default;
  friend auto operator<=>(const Point&, const Point&) = default;
};

/// A position in space. The default order is lexicographic, x before y before z.
struct SpacePoint {
  double x = 0;
  double y = 0;
  double z = 0;

  friend bool operator==(const SpacePoint&, const SpacePoint&) = default;
  friend auto operator<=>(const SpacePoint&, const SpacePoint&) = default;
};

namespace of_dimension {
template <int Dimension>
struct Position;
template <>
struct Position<2> {
  using Type = Point;
};
template <>
struct Position<3> {
  using Type = SpacePoint;
};
}  // namespace of_dimension

/// The type of a position: Point in the plane, SpacePoint in space.
template <int Dimension>
using PositionIn = typename of_dimension::Position<Dimension>::Type;

}  // namespace thiessen
