#pragma once

#include "geometry/point.h"

namespace thiessen {

/// The predicates' determinants in whole numbers: an independent judge for points on a grid, exact
/// for coordinates below 2^29 in magnitude.
namespace whole {

__extension__ using Wide = __int128;

struct Position {
  long long x;
  long long y;
};

inline Point point(Position p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}
inline int sign_of(Wide value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}
inline Wide square(Wide value) {
  return value * value;
}
inline Wide doubled_area(Position a, Position b, Position c) {
  return Wide{b.x - a.x} * (c.y - a.y) - Wide{b.y - a.y} * (c.x - a.x);
}
inline Wide square_distance(Position a, Position b) {
  return square(b.x - a.x) + square(b.y - a.y);
}
/// Positive where d is inside the circle through a, b, c, which run counter-clockwise.
inline Wide in_circle(Position a, Position b, Position c, Position d) {
  return square_distance(a, d) * doubled_area(d, b, c) +
         square_distance(b, d) * doubled_area(d, c, a) +
         square_distance(c, d) * doubled_area(d, a, b);
}

}  // namespace whole
}  // namespace thiessen
