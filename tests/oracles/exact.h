#pragma once

#include <boost/multiprecision/gmp.hpp>

#include "geometry/point.h"

namespace thiessen::exactly {

/// A number without rounding, from GMP: the judge of everything computed in doubles.
using Rational = boost::multiprecision::mpq_rational;

struct Position {
  Rational x;
  Rational y;

  friend bool operator==(const Position&, const Position&) = default;
};

struct SpacePosition {
  Rational x;
  Rational y;
  Rational z;

  friend bool operator==(const SpacePosition&, const SpacePosition&) = default;
};

inline Position position(Point p) {
  return {Rational(p.x), Rational(p.y)};
}
inline SpacePosition position(const SpacePoint& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}
inline Rational square(const Rational& r) {
  return r * r;
}
inline Rational square_distance(const Position& a, const Position& b) {
  return square(b.x - a.x) + square(b.y - a.y);
}
inline Rational square_distance(const SpacePosition& a, const SpacePosition& b) {
  return square(b.x - a.x) + square(b.y - a.y) + square(b.z - a.z);
}
inline Rational doubled_area(const Position& a, const Position& b, const Position& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
/// The determinant of the columns b - a, c - a, d - a: six times the tetrahedron's signed volume.
inline Rational sixfold_volume(const SpacePosition& a, const SpacePosition& b,
                               const SpacePosition& c, const SpacePosition& d) {
  const auto area = [&](const SpacePosition& s, const SpacePosition& t) {
    return Rational((s.x - a.x) * (t.y - a.y) - (s.y - a.y) * (t.x - a.x));
  };
  return (b.z - a.z) * area(c, d) - (c.z - a.z) * area(b, d) + (d.z - a.z) * area(b, c);
}
inline Rational in_circle(const Position& a, const Position& b, const Position& c,
                          const Position& d) {
  return square_distance(a, d) * doubled_area(d, b, c) +
         square_distance(b, d) * doubled_area(d, c, a) +
         square_distance(c, d) * doubled_area(d, a, b);
}
inline Position circumcentre(const Position& a, const Position& b, const Position& c) {
  const Rational bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const Rational b_square = square(bx) + square(by);
  const Rational c_square = square(cx) + square(cy);
  const Rational twice = 2 * (bx * cy - by * cx);
  return {a.x + (b_square * cy - c_square * by) / twice,
          a.y + (c_square * bx - b_square * cx) / twice};
}

}  // namespace thiessen::exactly
