#pragma once

#include <compare>

namespace thiessen {

/// A position in a plane: east and north in a projection, or longitude and latitude in degrees.
/// The default order is lexicographic, x before y; the tessellation breaks its ties by it.
struct Point {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point&, const Point&) = default;
  friend auto operator<=>(const Point&, const Point&) = default;
};

}  // namespace thiessen
