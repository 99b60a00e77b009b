#pragma once

#include "geometry/point.h"

namespace thiessen {

/// The predicates' determinants in whole numbers: an independent judge for points on a grid, exact
/// for coordinates below 2^29 in magnitude in the plane, 2^22 in space.
namespace whole {

__extension__ using Wide = __int128;

struct Position {
  long long x;
  long long y;
};
struct SpacePosition {
  long long x;
  long long y;
  long long z;
};

/// The point on the grid of that unit, a power of two: the signs do not depend on it.
inline Point point(Position p, double unit) {
  return {unit * static_cast<double>(p.x), unit * static_cast<double>(p.y)};
}
inline SpacePoint point(const SpacePosition& p, double unit) {
  return {unit * static_cast<double>(p.x), unit * static_cast<double>(p.y),
          unit * static_cast<double>(p.z)};
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
inline Wide square_distance(const SpacePosition& a, const SpacePosition& b) {
  return square(b.x - a.x) + square(b.y - a.y) + square(b.z - a.z);
}
/// The determinant of the columns b - a, c - a, d - a.
inline Wide sixfold_volume(const SpacePosition& a, const SpacePosition& b, const SpacePosition& c,
                           const SpacePosition& d) {
  const auto xy = [](const SpacePosition& p) { return Position{p.x, p.y}; };
  return (b.z - a.z) * doubled_area(xy(a), xy(c), xy(d)) -
         (c.z - a.z) * doubled_area(xy(a), xy(b), xy(d)) +
         (d.z - a.z) * doubled_area(xy(a), xy(b), xy(c));
}
/// Positive where d is inside the circle through a, b, c, which run counter-clockwise.
inline Wide in_circle(Position a, Position b, Position c, Position d) {
  return square_distance(a, d) * doubled_area(d, b, c) +
         square_distance(b, d) * doubled_area(d, c, a) +
         square_distance(c, d) * doubled_area(d, a, b);
}
/// Positive where e is inside the sphere through a, b, c, d, whose volume is positive.
inline Wide in_sphere(const SpacePosition& a, const SpacePosition& b, const SpacePosition& c,
                      const SpacePosition& d, const SpacePosition& e) {
  return square_distance(a, e) * sixfold_volume(e, b, c, d) +
         square_distance(b, e) * sixfold_volume(a, e, c, d) +
         square_distance(c, e) * sixfold_volume(a, b, e, d) +
         square_distance(d, e) * sixfold_volume(a, b, c, e);
}

}  // namespace whole
}  // namespace thiessen
