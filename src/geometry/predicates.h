#pragma once

#include <cmath>

#include "geometry/point.h"

namespace thiessen {

/// The coordinates for which every predicate below is exact: zero, or a magnitude from
/// smallest_coordinate to largest_coordinate. Differences of such numbers are multiples of 2^-194,
/// so the products of five of them that the in-sphere test takes neither underflow nor overflow,
/// nor do the products of four of the in-circle test.
inline constexpr double smallest_coordinate = 0x1p-142;  // 1.8e-43
inline constexpr double largest_coordinate = 0x1p201;    // 3.2e60

inline bool in_exact_range(double coordinate) {
  const double magnitude = std::abs(coordinate);
  return magnitude == 0 || (magnitude >= smallest_coordinate && magnitude <= largest_coordinate);
}
inline bool in_exact_range(Point p) {
  return in_exact_range(p.x) && in_exact_range(p.y);
}

/// Which side of the directed line a→b the point c is on: 1 left, -1 right, 0 on the line, exactly.
/// Laws: 1. orientation(b, a, c) == -orientation(a, b, c). 2. orientation(b, c, a) ==
/// orientation(a, b, c). Requires coordinates in the exact range. Cost: a few nanoseconds unless c
/// is within rounding of the line.
int orientation(Point a, Point b, Point c);

/// Twice the signed area of the triangle a, b, c with a relative error of 2^-48 at most, however
/// thin it is. Law: doubled_area(b, a, c) == -doubled_area(a, b, c), bit for bit.
double doubled_area(Point a, Point b, Point c);

/// Where d lies against the circle through a, b, c: 1 inside, -1 outside, 0 on it, exactly.
/// Requires orientation(a, b, c) > 0 and coordinates in the exact range.
/// Laws: 1. any even permutation of a, b, c gives the same. 2. For convex a, b, c, d in order,
/// in_circle(b, c, d, a) == -in_circle(a, b, c, d).
int in_circle(Point a, Point b, Point c, Point d);

/// As in_circle, but never 0: points on one circle are lifted, each infinitely less than the one
/// after it in lexicographic order (Devillers and Teillaud, Perturbations for Delaunay and weighted
/// Delaunay 3D triangulations, 2011), so that the answer depends on the positions alone. Requires
/// four different points and orientation(a, b, c) > 0.
bool in_perturbed_circle(Point a, Point b, Point c, Point d);

/// Which of a and b is nearer to `from`: -1 the first, 1 the second, 0 neither, exactly.
/// Requires coordinates in the exact range.
int compare_distance(Point from, Point a, Point b);

/// The centre of the circle through a, b, c; it does not depend on their order, bit for bit.
/// Requires that they are not on one line. Accuracy: 2^-47 of its distance from the
/// lexicographically first of the three, plus the rounding to doubles.
Point circumcentre(Point a, Point b, Point c);

}  // namespace thiessen
