#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "geometry/point.h"
#include "geometry/seeded.h"

namespace thiessen {

/// Points in space of the kinds that make each stage of the predicates' arithmetic decide.
enum class SpaceFamily {
  anywhere,
  lattice,
  lattice_far_out,
  tenths_far_out,
  ulps_apart,
  nearly_coplanar,
  coplanar,
  axis_parallel_plane,
  collinear,
  cospherical,
  cocircular,
  nearly_cospherical,
  mixed_scales,
  whole_range,
  ends_of_the_range,
  below_zero_half_units
};
inline constexpr int space_families = 16;

/// Five points of one family.
class SpaceSites {
 public:
  SpaceSites(Seeded& seeded, SpaceFamily family)
      : seeded_(seeded),
        family_(family),
        offset_{at_scale(-10, 30), at_scale(-10, 30), at_scale(-10, 30)} {}

  std::array<SpacePoint, 5> five() {
    std::array<SpacePoint, 5> p;
    for (SpacePoint& q : p) q = next();
    return p;
  }

 private:
  double small(int size) { return static_cast<double>(seeded_.whole(-size, size)); }
  double at_scale(int low, int high) {
    const double magnitude =
        std::ldexp(seeded_.uniform(1, 2), static_cast<int>(seeded_.whole(low, high)));
    return seeded_.below(2) == 0 ? magnitude : -magnitude;
  }
  double at_an_end() { return seeded_.below(2) == 0 ? at_scale(-142, -140) : at_scale(198, 200); }
  /// (+-1, +-2, +-3) in any order, all at distance sqrt(14) from the origin.
  SpacePoint on_the_sphere_of_14() {
    std::array<double, 3> c{1, 2, 3};
    std::shuffle(c.begin(), c.end(), seeded_.generator());
    for (double& x : c) x = seeded_.below(2) == 0 ? x : -x;
    return {c[0], c[1], c[2]};
  }
  SpacePoint next() {
    switch (family_) {
      case SpaceFamily::anywhere:
        return {seeded_.uniform(-1, 1), seeded_.uniform(-1, 1), seeded_.uniform(-1, 1)};
      case SpaceFamily::lattice:
        return {small(2), small(2), small(2)};
      case SpaceFamily::lattice_far_out:
        return {500000 + small(3), 4000000 + small(3), -70 + small(3)};
      case SpaceFamily::tenths_far_out:
        return {500000 + 0.1 * small(3), 4000000 + 0.1 * small(3), 100 + 0.1 * small(3)};
      case SpaceFamily::ulps_apart:
        return {seeded_.near(offset_.x, 3), seeded_.near(offset_.y, 3), seeded_.near(offset_.z, 3)};
      case SpaceFamily::nearly_coplanar: {
        const double x = seeded_.uniform(-1, 1), y = seeded_.uniform(-1, 1);
        return {x, y, seeded_.near(0.3 * x + 0.7 * y, 2)};
      }
      case SpaceFamily::coplanar: {
        const double s = small(1000), t = small(1000);
        return {500000 + s, 4000000 + t, 100 + 2 * s - 3 * t};
      }
      case SpaceFamily::axis_parallel_plane:
        return {seeded_.uniform(-1, 1), 0.3, seeded_.uniform(-1, 1)};
      case SpaceFamily::collinear: {
        const double t = small(1000);
        return {500000 + t, 4000000 - 2 * t, 7 + 3 * t};
      }
      case SpaceFamily::cospherical:
        return on_the_sphere_of_14();
      case SpaceFamily::cocircular: {
        // Two of its circles in parallel planes, so that four of five are often on one.
        const SpacePoint p = on_the_sphere_of_14();
        return seeded_.below(4) == 0 ? p : SpacePoint{p.x, p.y, std::abs(p.z)};
      }
      case SpaceFamily::nearly_cospherical: {
        const double angle = seeded_.uniform(0, 7), z = seeded_.uniform(-1, 1);
        const double r = std::sqrt(1 - z * z);
        return {offset_.x + r * std::cos(angle), offset_.y + r * std::sin(angle), offset_.z + z};
      }
      case SpaceFamily::mixed_scales: {
        SpacePoint p = on_the_sphere_of_14();
        return {p.x, std::ldexp(p.y, -70), std::ldexp(p.z, -20)};
      }
      case SpaceFamily::whole_range:
        return {at_scale(-142, 200), at_scale(-142, 200), at_scale(-142, 200)};
      case SpaceFamily::ends_of_the_range:
        return {at_an_end(), at_an_end(), at_an_end()};
      case SpaceFamily::below_zero_half_units:
        return {-0x1.8p51 + 0.5 * small(4), -0x1.1p51 + 0.5 * small(4), -0x1.4p51 + 0.5 * small(4)};
    }
    return {};
  }

  Seeded& seeded_;
  SpaceFamily family_;
  SpacePoint offset_;
};

/// Corners of a rectangle, which are on one circle, or whole multiples of two vectors.
inline std::array<SpacePoint, 4> points_of_a_plane_lattice(Seeded& seeded) {
  const auto whole = [&seeded](int size) { return static_cast<double>(seeded.whole(-size, size)); };
  const bool rectangle = seeded.below(2) == 0;
  const SpacePoint u{whole(3), whole(3), whole(3)};
  const SpacePoint v =
      rectangle ? SpacePoint{u.y, -u.x, 0} : SpacePoint{whole(3), whole(3), whole(3)};
  const double unit = std::ldexp(1, static_cast<int>(seeded.whole(-30, 0)));
  std::array<SpacePoint, 4> p;
  for (std::size_t i = 0; i < 4; ++i) {
    const double s = unit * (rectangle ? static_cast<double>(i % 2) : whole(1000));
    const double t = unit * (rectangle ? static_cast<double>(i / 2) : whole(1000));
    p.at(i) = {4000000 + s * u.x + t * v.x, -70 + s * u.y + t * v.y, 500000 + s * u.z + t * v.z};
  }
  return p;
}

/// Points in a plane through an axis at half a right angle, or across an axis, near one circle.
inline std::array<SpacePoint, 4> points_near_a_circle_in_a_plane(Seeded& seeded) {
  const auto kind = seeded.below(4);
  std::array<SpacePoint, 4> p;
  for (SpacePoint& q : p) {
    const double angle = seeded.uniform(0, 7);
    const double s = std::cos(angle), t = std::sin(angle);
    const double half = s * std::sqrt(0.5);
    q = kind == 0   ? SpacePoint{half, half, t}
        : kind == 1 ? SpacePoint{half, t, -half}
        : kind == 2 ? SpacePoint{s, 0.3, t}
                    : SpacePoint{10 + s, 20 + t, 0.3};
  }
  return p;
}

/// Four points of one plane, often on one circle or near it.
inline std::array<SpacePoint, 4> coplanar_points(Seeded& seeded) {
  auto p = seeded.below(2) == 0 ? points_of_a_plane_lattice(seeded)
                                : points_near_a_circle_in_a_plane(seeded);
  std::shuffle(p.begin(), p.end(), seeded.generator());
  return p;
}

template <std::size_t Count>
bool are_different(std::array<SpacePoint, Count> p) {
  std::sort(p.begin(), p.end());
  return std::adjacent_find(p.begin(), p.end()) == p.end();
}

/// Calls check(five points), of every family in turn.
template <class Check>
void for_all_families(std::uint64_t rounds, Check check) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(rounds); ++round) {
    const auto family = static_cast<int>(round % space_families);
    SCOPED_TRACE("family " + std::to_string(family) + ", round " + std::to_string(round));
    check(SpaceSites(seeded, static_cast<SpaceFamily>(family)).five());
    if (testing::Test::HasFatalFailure()) return;
  }
}

}  // namespace thiessen
