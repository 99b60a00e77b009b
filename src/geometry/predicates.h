#pragma once

#include <cmath>

#include "geometry/estimate.h"
#include "geometry/point.h"

namespace thiessen {

// Each predicate works in two stages. The first computes in doubles with a bound on the rounding
// errors (estimate.h); it is here in the header, so that it is put in line. Where the bound does
// not decide, the second computes in whole numbers (whole_vectors.h), out of line.
//
// The bounds count roundings to nearest, each operation by itself. So the processor's rounding mode
// must be to nearest (a caller's fesetround is to be taken back). For the same reason
// -ffp-contract=off in CMakeLists.txt keeps multiplications and additions from being fused, which
// would also make doubled_area(b, a, c) differ from -doubled_area(a, b, c), and the results of one
// machine from those of the next.

/// The coordinates for which every predicate below is exact: zero, or a magnitude from
/// smallest_coordinate to largest_coordinate. Differences of such numbers are multiples of 2^-194.
/// So neither the products of five of them that the in-sphere test takes nor the products of four
/// of the in-circle test underflow or overflow.
inline constexpr double smallest_coordinate = 0x1p-142;  // 1.8e-43
inline constexpr double largest_coordinate = 0x1p201;    // 3.2e60

/// Whether the predicates are exact for this coordinate, or for all coordinates of a point.
inline bool in_exact_range(double coordinate) {
  const double magnitude = std::abs(coordinate);
  return magnitude == 0 || (magnitude >= smallest_coordinate && magnitude <= largest_coordinate);
}
inline bool in_exact_range(Point p) {
  return in_exact_range(p.x) && in_exact_range(p.y);
}

/// The exact second stages of the predicates, which are called where the estimate of the first
/// stage does not decide.
namespace exact {
int orientation(Point a, Point b, Point c, Estimate area);
int in_circle(Point a, Point b, Point c, Point d, Estimate lift);
bool breaks_tie_inside(Point a, Point b, Point c, Point d);
int compare_distance(Point from, Point a, Point b, Estimate difference);
Point circumcentre(Point a, Point b, Point c);
}  // namespace exact

/// The side of the directed line a→b on which the point c is, exactly: 1 left, -1 right, 0 on the
/// line.
/// Laws: 1. orientation(b, a, c) == -orientation(a, b, c). 2. orientation(b, c, a) ==
/// orientation(a, b, c).
/// Requires coordinates in the exact range. Cost: a few nanoseconds unless c is within rounding of
/// the line.
inline int orientation(Point a, Point b, Point c) {
  const Estimate area = determinant::area(estimated_vector(c, a), estimated_vector(c, b));
  if (area.is_certain_after<3>()) [[likely]]
    return area.sign();
  return exact::orientation(a, b, c, area);
}

/// Twice the signed area of the triangle a, b, c. The relative error is at most 25 * 2^-53
/// (2^-48.3), however thin the triangle is. Law: doubled_area(b, a, c) == -doubled_area(a, b, c),
/// bit for bit.
double doubled_area(Point a, Point b, Point c);

/// The side of the circle through a, b, c on which d is, exactly: 1 inside, -1 outside, 0 on it.
/// Requires orientation(a, b, c) > 0 and coordinates in the exact range.
/// Laws: 1. Any even permutation of a, b, c gives the same. 2. For convex a, b, c, d in order,
/// in_circle(b, c, d, a) == -in_circle(a, b, c, d).
inline int in_circle(Point a, Point b, Point c, Point d) {
  const Estimate lift = estimated_lift(a, b, c, d);
  if (lift.is_certain_after<10>()) [[likely]]
    return lift.sign();
  return exact::in_circle(a, b, c, d, lift);
}

/// Whether d is inside the circle through a, b, c, where ties are broken by a perturbation: points
/// on one circle are lifted, each infinitely less than the one after it in lexicographic order
/// (Devillers and Teillaud, Perturbations for Delaunay and weighted Delaunay 3D triangulations,
/// 2011). So the answer depends on the positions alone, and an even permutation of a, b, c changes
/// nothing. Requires four different points, orientation(a, b, c) > 0 and coordinates in the exact
/// range.
inline bool in_perturbed_circle(Point a, Point b, Point c, Point d) {
  const Estimate lift = estimated_lift(a, b, c, d);
  if (lift.is_certain_after<10>() && lift.value != 0) [[likely]]
    return lift.value > 0;
  const int side = exact::in_circle(a, b, c, d, lift);
  if (side != 0) return side > 0;
  return exact::breaks_tie_inside(a, b, c, d);
}

/// Which of a and b is nearer to `from`, exactly: -1 for a, 1 for b, 0 where both are equally near.
/// Requires coordinates in the exact range.
inline int compare_distance(Point from, Point a, Point b) {
  const Estimate difference = determinant::square(estimated_vector(from, a)) -
                              determinant::square(estimated_vector(from, b));
  if (difference.is_certain_after<4>()) [[likely]]
    return difference.sign();
  return exact::compare_distance(from, a, b, difference);
}

/// The centre of the circle through a, b, c. It does not depend on their order, bit for bit.
/// Requires that they are not on one line. Accuracy: 2^-51 of the centre's distance from the
/// lexicographically first of the three, however thin the triangle, plus the rounding to doubles.
Point circumcentre(Point a, Point b, Point c);

}  // namespace thiessen
