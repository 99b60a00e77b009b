#include "geometry/space_predicates.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/lexicographic.h"
#include "geometry/whole_vectors.h"

namespace thiessen {
namespace {

template <class Number>
PlaneVector<Number> projected(Axis dropped, const SpaceVector<Number>& u) {
  if (dropped == Axis::x) return {u.y, u.z};
  if (dropped == Axis::y) return {u.z, u.x};
  return {u.x, u.y};
}

/// The in-circle determinant of the projections, with the squares of the vectors in space.
template <class Number>
auto circle_in_plane(Axis dropped, const SpaceVector<Number>& u, const SpaceVector<Number>& v,
                     const SpaceVector<Number>& w) {
  return determinant::in_circle(determinant::square(u), projected(dropped, u),
                                determinant::square(v), projected(dropped, v),
                                determinant::square(w), projected(dropped, w));
}

}  // namespace

int exact::orientation(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                       const SpacePoint& d, Estimate volume) {
  if (volume.is_exact_for<3>(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z))
    return volume.sign();
  return in_whole_numbers(std::array<SpacePoint, 4>{b, c, d, a}, [](const auto& vectors) {
    const auto& [ab, ac, ad] = vectors.to;
    return determinant::volume(ab, ac, ad).sign();
  });
}

int exact::in_sphere(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                     const SpacePoint& d, const SpacePoint& e, Estimate quick) {
  if (quick.is_exact_for<5>(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x, e.y,
                            e.z))
    return quick.sign();
  const Estimate lift = estimated_lift(a, b, c, d, e);
  if (lift.is_certain_after<15>()) return lift.sign();
  return in_whole_numbers(std::array<SpacePoint, 5>{a, b, c, d, e}, [](const auto& vectors) {
    const auto& [ea, eb, ec, ed] = vectors.to;
    return determinant::in_sphere(ea, eb, ec, ed).sign();
  });
}

// The highest lift decides unless its coefficient in the determinant is zero. The coefficient is an
// orientation of the other four points, so it is zero where these are on one circle. Then the next
// lift decides, because that point is on the circle and the highest is not in its plane. Lifting e
// makes it outside. Lifting a corner makes e inside where e sees the other three corners in the
// same sense as the corner does.
bool exact::breaks_tie_inside(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                              const SpacePoint& d, const SpacePoint& e) {
  const std::array<const SpacePoint*, 5> points{&a, &b, &c, &d, &e};
  const auto coefficient_of = [&points](std::size_t lifted) {
    if (lifted == 4) return -1;
    auto seen = points;
    seen[lifted] = points[4];
    return thiessen::orientation(*seen[0], *seen[1], *seen[2], *seen[3]);
  };
  const std::size_t highest = lexicographically_last(points);
  const int coefficient = coefficient_of(highest);
  if (coefficient != 0) return coefficient > 0;
  return coefficient_of(lexicographically_last(points, highest)) > 0;
}

int exact::compare_distance(const SpacePoint& from, const SpacePoint& a, const SpacePoint& b,
                            Estimate difference) {
  if (difference.is_exact_for<2>(from.x, from.y, from.z, a.x, a.y, a.z, b.x, b.y, b.z))
    return difference.sign();
  return in_whole_numbers(std::array<SpacePoint, 3>{a, b, from}, [](const auto& vectors) {
    return (determinant::square(vectors.to[0]) - determinant::square(vectors.to[1])).sign();
  });
}

SpacePoint circumcentre(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                        const SpacePoint& d) {
  std::array<SpacePoint, 4> p{a, b, c, d};
  std::sort(p.rbegin(), p.rend());  // the lexicographically first comes last, as the origin
  return exact::in_whole_numbers(p, [&p](const auto& vectors) {
    const auto& [u, v, w] = vectors.to;
    const auto u_square = determinant::square(u);
    const auto v_square = determinant::square(v);
    const auto w_square = determinant::square(w);
    const auto vw = determinant::cross(v, w);
    const auto wu = determinant::cross(w, u);
    const auto uv = determinant::cross(u, v);
    const double twice_volume =
        2 * (u.x * vw.x + u.y * vw.y + u.z * vw.z).to_double(3 * vectors.exponent);
    const auto coordinate = [&](double origin, const auto& vw_part, const auto& wu_part,
                                const auto& uv_part) {
      const auto numerator = u_square * vw_part + v_square * wu_part + w_square * uv_part;
      return origin + numerator.to_double(4 * vectors.exponent) / twice_volume;
    };
    return SpacePoint{coordinate(p.back().x, vw.x, wu.x, uv.x),
                      coordinate(p.back().y, vw.y, wu.y, uv.y),
                      coordinate(p.back().z, vw.z, wu.z, uv.z)};
  });
}

bool are_collinear(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
  return orientation_in_plane(Axis::x, a, b, c) == 0 &&
         orientation_in_plane(Axis::y, a, b, c) == 0 && orientation_in_plane(Axis::z, a, b, c) == 0;
}

Axis projection_axis(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
  if (orientation_in_plane(Axis::x, a, b, c) != 0) return Axis::x;
  if (orientation_in_plane(Axis::y, a, b, c) != 0) return Axis::y;
  return Axis::z;
}

int in_circle_in_plane(Axis dropped, const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                       const SpacePoint& d) {
  const Estimate lift = circle_in_plane(dropped, estimated_vector(d, a), estimated_vector(d, b),
                                        estimated_vector(d, c));
  if (lift.is_certain_after<11>()) return lift.sign();
  return exact::in_whole_numbers(std::array<SpacePoint, 4>{a, b, c, d},
                                 [dropped](const auto& vectors) {
                                   const auto& [da, db, dc] = vectors.to;
                                   return circle_in_plane(dropped, da, db, dc).sign();
                                 });
}

// The highest lift decides, as in the plane.
bool in_perturbed_circle_in_plane(Axis dropped, const SpacePoint& a, const SpacePoint& b,
                                  const SpacePoint& c, const SpacePoint& d) {
  const int side = in_circle_in_plane(dropped, a, b, c, d);
  if (side != 0) return side > 0;
  std::array<const SpacePoint*, 4> points{&a, &b, &c, &d};
  const std::size_t highest = lexicographically_last(points);
  if (highest == 3) return false;
  points[highest] = &d;
  return orientation_in_plane(dropped, *points[0], *points[1], *points[2]) > 0;
}

}  // namespace thiessen
