#pragma once

#include <cstdint>

#include "geometry/estimate.h"
#include "geometry/point.h"
#include "geometry/predicates.h"

namespace thiessen {

// These are the predicates of predicates.h in space, in the same two stages and with the same
// requirements: coordinates in the exact range, rounding to nearest. All are exact. All but the
// circumcentre cost a few nanoseconds, unless the estimate is zero but for rounding.

inline bool in_exact_range(const SpacePoint& p) {
  return in_exact_range(p.x) && in_exact_range(p.y) && in_exact_range(p.z);
}

/// An axis along which a plane is projected: x onto (y, z), y onto (z, x), z onto (x, y). With this
/// order of coordinates, every projection keeps the sense of rotation as seen from its axis.
enum class Axis : std::uint8_t { x, y, z };

/// The projection of p along an axis.
inline Point projected(Axis dropped, const SpacePoint& p) {
  if (dropped == Axis::x) return {p.y, p.z};
  if (dropped == Axis::y) return {p.z, p.x};
  return {p.x, p.y};
}

/// The exact second stages of the predicates, which are called where the estimate of the first
/// stage does not decide.
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

/// The orientation of the tetrahedron, which is the sign of det[b - a, c - a, d - a]: 1 where d is
/// on the side from which a, b, c are seen counter-clockwise, -1 where it is on the other side, 0
/// where it is in their plane.
/// Laws: 1. An odd permutation of the points changes the sign. 2. An even one changes nothing.
inline int orientation(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                       const SpacePoint& d) {
  const Estimate volume =
      determinant::volume(estimated_vector(a, b), estimated_vector(a, c), estimated_vector(a, d));
  if (volume.is_certain_after<7>()) [[likely]]
    return volume.sign();
  return exact::orientation(a, b, c, d, volume);
}

/// The side of the sphere through a, b, c, d on which e is: 1 inside, -1 outside, 0 on it. Requires
/// orientation(a, b, c, d) > 0.
/// Laws: 1. An even permutation of a, b, c, d changes nothing.
/// 2. Where orientation(e, b, c, d) > 0, in_sphere(e, b, c, d, a) == -in_sphere(a, b, c, d, e);
/// where it is < 0, in_sphere(b, e, c, d, a) == in_sphere(a, b, c, d, e).
inline int in_sphere(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                     const SpacePoint& d, const SpacePoint& e) {
  const Estimate lift = quick_lift(a, b, c, d, e);
  if (lift.is_certain_after<15>()) [[likely]]
    return lift.sign();
  return exact::in_sphere(a, b, c, d, e, lift);
}

/// Whether e is inside the sphere through a, b, c, d, where ties are broken by a perturbation:
/// points on one sphere are lifted, each infinitely less than the one after it in lexicographic
/// order, as in in_perturbed_circle. Requires five different points and orientation(a, b, c, d) >
/// 0.
/// Laws: 1. The answer depends on the positions alone: an even permutation of a, b, c, d changes
/// nothing. 2. Law 2 of in_sphere holds, with "inside" for 1 and "outside" for -1.
inline bool in_perturbed_sphere(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                                const SpacePoint& d, const SpacePoint& e) {
  const int side = in_sphere(a, b, c, d, e);
  if (side != 0) [[likely]]
    return side > 0;
  return exact::breaks_tie_inside(a, b, c, d, e);
}

/// Which of a and b is nearer to `from`: -1 for a, 1 for b, 0 where both are equally near.
inline int compare_distance(const SpacePoint& from, const SpacePoint& a, const SpacePoint& b) {
  const Estimate difference = determinant::square(estimated_vector(from, a)) -
                              determinant::square(estimated_vector(from, b));
  if (difference.is_certain_after<5>()) [[likely]]
    return difference.sign();
  return exact::compare_distance(from, a, b, difference);
}

/// The centre of the sphere through a, b, c, d. It does not depend on their order, bit for bit.
/// Requires that they are not in one plane. Accuracy: 2^-51 of the centre's distance from the
/// lexicographically first of the four, however flat they are, plus the rounding to doubles.
SpacePoint circumcentre(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                        const SpacePoint& d);

/// The orientation in the plane of the points' projections along an axis. Laws: as for orientation
/// in the plane.
inline int orientation_in_plane(Axis dropped, const SpacePoint& a, const SpacePoint& b,
                                const SpacePoint& c) {
  return orientation(projected(dropped, a), projected(dropped, b), projected(dropped, c));
}

/// Whether a, b, c lie on one line, which includes that two of them coincide.
bool are_collinear(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c);

/// The first axis along which the triangle can be projected without becoming flat. It depends on
/// the triangle's plane alone. Requires that a, b, c are not collinear.
Axis projection_axis(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c);

/// The side of the circle through a, b, c on which d is, in their plane: 1 inside, -1 outside, 0 on
/// it. Requires four points of one plane and orientation_in_plane(dropped, a, b, c) > 0.
/// Laws: 1. An even permutation of a, b, c changes nothing. 2. Any other axis along which the plane
/// does not become flat gives the same, with a and b exchanged where their projection turns the
/// other way.
int in_circle_in_plane(Axis dropped, const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                       const SpacePoint& d);

/// Whether d is inside the circle through a, b, c in their plane, where ties are broken as in
/// in_perturbed_sphere, in lexicographic order in space. Requires four different points of one
/// plane and orientation_in_plane(dropped, a, b, c) > 0.
/// Laws: 1. and 2. as for in_circle_in_plane. 3. in_perturbed_sphere(a, b, c, apex, d) is the same
/// for every apex with orientation(a, b, c, apex) > 0.
bool in_perturbed_circle_in_plane(Axis dropped, const SpacePoint& a, const SpacePoint& b,
                                  const SpacePoint& c, const SpacePoint& d);

}  // namespace thiessen
