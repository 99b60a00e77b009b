#pragma once

#include <cmath>

#include "geometry/estimate.h"
#include "geometry/point.h"

namespace thiessen {

// Each predicate first computes in doubles with a bound on the rounding errors (estimate.h), here
// in the header; where that does not decide, in whole numbers (whole_vectors.h), out of line. The
// bounds count roundings to nearest, each operation by itself: so the processor's rounding mode
// must be to nearest (a caller's fesetround is to be taken back), and -ffp-contract=off in
// CMakeLists.txt keeps multiplications and additions from being fused, which would also make
// doubled_area(b, a, c) differ from -doubled_area(a, b, c), and results from one machine to the
// next.

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

/// The predicates where their estimates do not decide.
namespace exact {
int orientation(Point a, Point b, Point c, Estimate area);
int in_circle(Point a, Point b, Point c, Point d, Estimate lift);
bool breaks_tie_inside(Point a, Point b, Point c, Point d);
int compare_distance(Point from, Point a, Point b, Estimate difference);
}  // namespace exact

/// Which side of the directed line a→b the point c is on: 1 left, -1 right, 0 on the line, exactly.
/// Laws: 1. orientation(b, a, c) == -orientation(a, b, c). 2. orientation(b, c, a) ==
/// orientation(a, b, c). Requires coordinates in the exact range. Cost: a few nanoseconds unless c
/// is within rounding of the line.
inline int orientation(Point a, Point b, Point c) {
  const Estimate area = determinant::area(estimated_vector(c, a), estimated_vector(c, b));
  if (area.is_certain_after<3>()) [[likely]]
    return area.sign();
  return exact::orientation(a, b, c, area);
}

/// Twice the signed area of the triangle a, b, c with a relative error of 25 * 2^-53 (2^-48.3) at
/// most, however thin it is. Law: doubled_area(b, a, c) == -doubled_area(a, b, c), bit for bit.
double doubled_area(Point a, Point b, Point c);

/// Where d lies against the circle through a, b, c: 1 inside, -1 outside, 0 on it, exactly.
/// Requires orientation(a, b, c) > 0 and coordinates in the exact range.
/// Laws: 1. any even permutation of a, b, c gives the same. 2. For convex a, b, c, d in order,
/// in_circle(b, c, d, a) == -in_circle(a, b, c, d).
inline int in_circle(Point a, Point b, Point c, Point d) {
  const Estimate lift = estimated_lift(a, b, c, d);
  if (lift.is_certain_after<10>()) [[likely]]
    return lift.sign();
  return exact::in_circle(a, b, c, d, lift);
}

/// As in_circle, but never 0: points on one circle are lifted, each infinitely less than the one
/// after it in lexicographic order (Devillers and Teillaud, Perturbations for Delaunay and weighted
/// Delaunay 3D triangulations, 2011), so that the answer depends on the positions alone: an even
/// permutation of a, b, c changes nothing. Requires four different points and
/// orientation(a, b, c) > 0.
inline bool in_perturbed_circle(Point a, Point b, Point c, Point d) {
  const Estimate lift = estimated_lift(a, b, c, d);
  if (lift.is_certain_after<10>() && lift.value != 0) [[likely]]
    return lift.value > 0;
  const int side = exact::in_circle(a, b, c, d, lift);
  if (side != 0) return side > 0;
  return exact::breaks_tie_inside(a, b, c, d);
}

/// Which of a and b is nearer to `from`: -1 the first, 1 the second, 0 neither, exactly.
/// Requires coordinates in the exact range.
inline int compare_distance(Point from, Point a, Point b) {
  const Estimate difference = determinant::square(estimated_vector(from, a)) -
                              determinant::square(estimated_vector(from, b));
  if (difference.is_certain_after<4>()) [[likely]]
    return difference.sign();
  return exact::compare_distance(from, a, b, difference);
}

/// The centre of the circle through a, b, c; it does not depend on their order, bit for bit.
/// Requires that they are not on one line. Accuracy: 2^-51 of its distance from the
/// lexicographically first of the three, however thin the triangle, plus the rounding to doubles.
Point circumcentre(Point a, Point b, Point c);

}  // namespace thiessen
