#pragma once

#include <cstdint>

#include "geometry/estimate.h"
#include "geometry/point.h"
#include "geometry/predicates.h"

namespace thiessen {

// The predicates of predicates.h in space, in the same two stages and with the same requirements:
// coordinates in the exact range, rounding to nearest. All are exact, and all but the circumcentre
// cost a few nanoseconds unless the answer is zero but for rounding.

inline bool in_exact_range(const SpacePoint& p) {
  return in_exact_range(p.x) && in_exact_range(p.y) && in_exact_range(p.z);
}

/// An axis along which a plane is projected: onto (y, z), (z, x) or (x, y), so that every
/// projection turns as seen from its axis.
enum class Axis : std::uint8_t { x, y, z };

inline Point projected(Axis dropped, const SpacePoint& p) {
  if (dropped == Axis::x) return {p.y, p.z};
  if (dropped == Axis::y) return {p.z, p.x};
  return {p.x, p.y};
}

/// The predicates where their estimates do not decide.
namespace exact {
int orientation(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c, const SpacePoint& d,
                Estimate volume);
int in_sphere(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c, const SpacePoint& d,
              const SpacePoint& e, Estimate quick);
bool breaks_tie_inside(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                       const SpacePoint& d, const SpacePoint& e);
int compare_distance(const SpacePoint& from, const SpacePoint& a, const SpacePoint& b,
                     Estimate difference);
}  // namespace exact

/// The sign of det[b - a, c - a, d - a]: 1 where d is on the side from which a, b, c are seen
/// counter-clockwise, -1 on the other side, 0 in their plane.
/// Laws: 1. An odd permutation of the points changes the sign. 2. An even one changes nothing.
inline int orientation(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                       const SpacePoint& d) {
  const Estimate volume =
      determinant::volume(estimated_vector(a, b), estimated_vector(a, c), estimated_vector(a, d));
  if (volume.is_certain_after<7>()) [[likely]]
    return volume.sign();
  return exact::orientation(a, b, c, d, volume);
}

/// Where e lies against the sphere through a, b, c, d: 1 inside, -1 outside, 0 on it.
/// Requires orientation(a, b, c, d) > 0.
/// Laws: 1. An even permutation of a, b, c, d changes nothing. 2. Where orientation(e, b, c, d) >
/// 0, in_sphere(e, b, c, d, a) == -in_sphere(a, b, c, d, e); where it is < 0, in_sphere(b, e, c, d,
/// a)
/// == in_sphere(a, b, c, d, e).
inline int in_sphere(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                     const SpacePoint& d, const SpacePoint& e) {
  const Estimate lift = quick_lift(a, b, c, d, e);
  if (lift.is_certain_after<15>()) [[likely]]
    return lift.sign();
  return exact::in_sphere(a, b, c, d, e, lift);
}

/// As in_sphere, but never 0: points on one sphere are lifted, each infinitely less than the one
/// after it in lexicographic order, as in in_perturbed_circle. Requires five different points and
/// orientation(a, b, c, d) > 0.
/// Laws: 1. The answer depends on the positions alone: an even permutation of a, b, c, d changes
/// nothing. 2. As law 2 of in_sphere.
inline bool in_perturbed_sphere(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                                const SpacePoint& d, const SpacePoint& e) {
  const int side = in_sphere(a, b, c, d, e);
  if (side != 0) [[likely]]
    return side > 0;
  return exact::breaks_tie_inside(a, b, c, d, e);
}

/// Which of a and b is nearer to `from`: -1 the first, 1 the second, 0 neither.
inline int compare_distance(const SpacePoint& from, const SpacePoint& a, const SpacePoint& b) {
  const Estimate difference = determinant::square(estimated_vector(from, a)) -
                              determinant::square(estimated_vector(from, b));
  if (difference.is_certain_after<5>()) [[likely]]
    return difference.sign();
  return exact::compare_distance(from, a, b, difference);
}

/// The centre of the sphere through a, b, c, d; it does not depend on their order, bit for bit.
/// Requires that they are not in one plane. Accuracy: 2^-51 of its distance from the
/// lexicographically first of the four, however flat they are, plus the rounding to doubles.
SpacePoint circumcentre(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                        const SpacePoint& d);

/// The orientation of the projections along an axis. Laws: as for orientation in the plane.
inline int orientation_in_plane(Axis dropped, const SpacePoint& a, const SpacePoint& b,
                                const SpacePoint& c) {
  return orientation(projected(dropped, a), projected(dropped, b), projected(dropped, c));
}

/// Whether a, b, c lie on one line, or two of them coincide.
bool are_collinear(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c);

/// The first axis along which the triangle can be projected without getting flat: a function of
/// its plane alone. Requires that a, b, c are not collinear.
Axis projection_axis(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c);

/// Where d lies against the circle through a, b, c in their plane: 1 inside, -1 outside, 0 on it.
/// Requires four points of one plane and orientation_in_plane(dropped, a, b, c) > 0.
/// Laws: 1. An even permutation of a, b, c changes nothing. 2. Any other axis along which the plane
/// does not get flat gives the same, with a and b exchanged where it turns them the other way.
int in_circle_in_plane(Axis dropped, const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                       const SpacePoint& d);

/// As in_circle_in_plane, but never 0: ties are broken as by in_perturbed_sphere, in lexicographic
/// order in space. Requires, beside that, four different points.
/// Laws: 1. and 2. as for in_circle_in_plane. 3. in_perturbed_sphere(a, b, c, apex, d) is the same
/// for every apex with orientation(a, b, c, apex) > 0.
bool in_perturbed_circle_in_plane(Axis dropped, const SpacePoint& a, const SpacePoint& b,
                                  const SpacePoint& c, const SpacePoint& d);

}  // namespace thiessen
