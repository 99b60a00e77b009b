// The predicates in space against rational numbers and against CGAL's over the same.
#include "geometry/space_predicates.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "geometry/seeded.h"
#include "geometry/space_families.h"
#include "oracles/exact.h"

namespace thiessen {
namespace {

using exactly::position;
using exactly::Rational;
using exactly::SpacePosition;
using Five = std::array<SpacePoint, 5>;
using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;

Kernel::Point_3 cgal(const SpacePoint& p) {
  return {CGAL::Gmpq(p.x), CGAL::Gmpq(p.y), CGAL::Gmpq(p.z)};
}
Kernel::Point_2 cgal(const Point& p) {
  return {CGAL::Gmpq(p.x), CGAL::Gmpq(p.y)};
}

/// The determinant of the lifted e under the lifted a, b, c, d, whose lifts are given.
Rational lift_determinant(const Five& p, const std::array<Rational, 5>& lift) {
  const auto q = [&](std::size_t i) { return position(p.at(i)); };
  return (lift[0] - lift[4]) * exactly::sixfold_volume(q(4), q(1), q(2), q(3)) +
         (lift[1] - lift[4]) * exactly::sixfold_volume(q(0), q(4), q(2), q(3)) +
         (lift[2] - lift[4]) * exactly::sixfold_volume(q(0), q(1), q(4), q(3)) +
         (lift[3] - lift[4]) * exactly::sixfold_volume(q(0), q(1), q(2), q(4));
}
std::array<Rational, 5> true_lifts(const Five& p) {
  std::array<Rational, 5> lift;
  for (std::size_t i = 0; i < 5; ++i)
    lift[i] = exactly::square_distance(position(p[i]), position(p[4]));
  return lift;
}

/// How far p is lifted: eps^k, where k is 1 for the lexicographically last of `among`, 2 for the
/// one before it, and so on.
template <std::size_t Count>
Rational step_of(const SpacePoint& p, const std::array<SpacePoint, Count>& among,
                 const Rational& epsilon) {
  Rational step = 1;
  for (const SpacePoint& q : among) {
    if (q >= p) step *= epsilon;
  }
  return step;
}

TEST(SpacePredicatesAgainstExact, orientation) {
  for_all_families(40000, [](const Five& p) {
    const int side = orientation(p[0], p[1], p[2], p[3]);
    const Rational volume =
        exactly::sixfold_volume(position(p[0]), position(p[1]), position(p[2]), position(p[3]));
    ASSERT_EQ(side, volume.sign());
    ASSERT_EQ(side, CGAL::orientation(cgal(p[0]), cgal(p[1]), cgal(p[2]), cgal(p[3])));
  });
}

TEST(SpacePredicatesAgainstExact, in_sphere) {
  int on_sphere = 0;
  for_all_families(40000, [&](Five p) {
    const int side = orientation(p[0], p[1], p[2], p[3]);
    if (side == 0) return;
    if (side < 0) std::swap(p[0], p[1]);
    const int answer = in_sphere(p[0], p[1], p[2], p[3], p[4]);
    on_sphere += static_cast<int>(answer == 0 && are_different(p));
    ASSERT_EQ(answer, lift_determinant(p, true_lifts(p)).sign());
    ASSERT_EQ(answer, CGAL::side_of_oriented_sphere(cgal(p[0]), cgal(p[1]), cgal(p[2]), cgal(p[3]),
                                                    cgal(p[4])));
  });
  EXPECT_GT(on_sphere, 500);
}

TEST(SpacePredicatesAgainstExact, compare_distance) {
  for_all_families(40000, [](const Five& p) {
    const int nearer = compare_distance(p[0], p[1], p[2]);
    const Rational difference = exactly::square_distance(position(p[0]), position(p[1])) -
                                exactly::square_distance(position(p[0]), position(p[2]));
    ASSERT_EQ(nearer, difference.sign());
    ASSERT_EQ(nearer, CGAL::compare_distance_to_point(cgal(p[0]), cgal(p[1]), cgal(p[2])));
  });
}

TEST(SpacePredicatesAgainstExact, are_collinear) {
  int collinear = 0;
  for_all_families(40000, [&](const Five& p) {
    const bool answer = are_collinear(p[0], p[1], p[2]);
    collinear += static_cast<int>(answer);
    ASSERT_EQ(answer, CGAL::collinear(cgal(p[0]), cgal(p[1]), cgal(p[2])));
  });
  EXPECT_GT(collinear, 1000);
}

TEST(SpacePredicatesAgainstExact, projection_axis_and_orientation_in_plane) {
  std::map<Axis, int> times;
  for_all_families(40000, [&](const Five& p) {
    const auto exact_side = [&](Axis axis) {
      return CGAL::orientation(cgal(projected(axis, p[0])), cgal(projected(axis, p[1])),
                               cgal(projected(axis, p[2])));
    };
    for (const Axis axis : {Axis::x, Axis::y, Axis::z})
      ASSERT_EQ(orientation_in_plane(axis, p[0], p[1], p[2]), exact_side(axis));
    if (are_collinear(p[0], p[1], p[2])) return;
    const Axis chosen = projection_axis(p[0], p[1], p[2]);
    ++times[chosen];
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      if (axis < chosen) {
        ASSERT_EQ(exact_side(axis), 0);
      } else if (axis == chosen) {
        ASSERT_NE(exact_side(axis), 0);
      }
    }
  });
  EXPECT_EQ(times.size(), 3u);
}

TEST(SpacePredicatesAgainstExact, in_circle_in_plane) {
  Seeded seeded;
  int on_circle = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(40000); ++round) {
    std::array<SpacePoint, 4> p = coplanar_points(seeded);
    const auto axis = static_cast<Axis>(seeded.below(3));
    const int turn = orientation_in_plane(axis, p[0], p[1], p[2]);
    if (turn == 0 || !are_different(p)) continue;
    if (turn < 0) std::swap(p[0], p[1]);
    ASSERT_TRUE(CGAL::coplanar(cgal(p[0]), cgal(p[1]), cgal(p[2]), cgal(p[3])));
    const int side = in_circle_in_plane(axis, p[0], p[1], p[2], p[3]);
    on_circle += static_cast<int>(side == 0);
    ASSERT_EQ(side, CGAL::coplanar_side_of_bounded_circle(cgal(p[0]), cgal(p[1]), cgal(p[2]),
                                                          cgal(p[3])));
  }
  EXPECT_GT(on_circle, 2000);
}

// The predicate as it is defined, with an eps small enough for these whole numbers: volumes are
// below 2^11 and a lift's steps at least 2^60 apart.
TEST(SpacePredicatesAgainstExact, in_perturbed_sphere_is_in_sphere_with_lifted_points) {
  const Rational epsilon(0x1p-60);
  Seeded seeded;
  int on_sphere = 0;
  int four_on_a_circle = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(40000); ++round) {
    const SpaceFamily family =
        std::array{SpaceFamily::lattice, SpaceFamily::cospherical, SpaceFamily::cocircular}.at(
            round % 3);
    Five p = SpaceSites(seeded, family).five();
    const int side = orientation(p[0], p[1], p[2], p[3]);
    if (side == 0 || !are_different(p)) continue;
    if (side < 0) std::swap(p[0], p[1]);
    std::array<Rational, 5> lift = true_lifts(p);
    for (std::size_t i = 0; i < 5; ++i) lift[i] += step_of(p[i], p, epsilon);
    if (in_sphere(p[0], p[1], p[2], p[3], p[4]) == 0) {
      ++on_sphere;
      for (std::size_t i = 0; i < 4; ++i) {
        Five without = p;
        std::swap(without[i], without[4]);
        four_on_a_circle +=
            static_cast<int>(orientation(without[0], without[1], without[2], without[3]) == 0);
      }
    }
    ASSERT_EQ(in_perturbed_sphere(p[0], p[1], p[2], p[3], p[4]), lift_determinant(p, lift) > 0);
  }
  EXPECT_GT(on_sphere, 2000);
  EXPECT_GT(four_on_a_circle, 500);
}

TEST(SpacePredicatesAgainstExact, in_perturbed_circle_in_plane_is_in_circle_with_lifted_points) {
  const Rational epsilon(0x1p-500);
  Seeded seeded;
  int on_circle = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(40000); ++round) {
    std::array<SpacePoint, 4> p = coplanar_points(seeded);
    const auto axis = static_cast<Axis>(seeded.below(3));
    const int turn = orientation_in_plane(axis, p[0], p[1], p[2]);
    if (turn == 0 || !are_different(p)) continue;
    if (turn < 0) std::swap(p[0], p[1]);
    on_circle += static_cast<int>(in_circle_in_plane(axis, p[0], p[1], p[2], p[3]) == 0);
    const auto area = [&](std::size_t i, std::size_t j, std::size_t k) {
      return exactly::doubled_area(position(projected(axis, p.at(i))),
                                   position(projected(axis, p.at(j))),
                                   position(projected(axis, p.at(k))));
    };
    std::array<Rational, 4> lift;
    for (std::size_t i = 0; i < 4; ++i)
      lift[i] =
          exactly::square_distance(position(p[i]), position(p[3])) + step_of(p[i], p, epsilon);
    const Rational determinant = (lift[0] - lift[3]) * area(3, 1, 2) +
                                 (lift[1] - lift[3]) * area(0, 3, 2) +
                                 (lift[2] - lift[3]) * area(0, 1, 3);
    ASSERT_EQ(in_perturbed_circle_in_plane(axis, p[0], p[1], p[2], p[3]), determinant > 0);
  }
  EXPECT_GT(on_circle, 2000);
}

// Measured, in units of 2^-53 of the distance from the first point, beside the last rounding.
TEST(SpacePredicatesAgainstExact, circumcentre_is_right_to_2_to_the_minus_51) {
  double worst = 0;
  for_all_families(20000, [&](const Five& p) {
    if (orientation(p[0], p[1], p[2], p[3]) == 0) return;
    const auto true_centre = CGAL::circumcenter(cgal(p[0]), cgal(p[1]), cgal(p[2]), cgal(p[3]));
    const SpacePoint centre = circumcentre(p[0], p[1], p[2], p[3]);
    const SpacePoint first = std::min({p[0], p[1], p[2], p[3]});
    const std::array<std::pair<CGAL::Gmpq, double>, 3> coordinates{
        {{true_centre.x(), centre.x}, {true_centre.y(), centre.y}, {true_centre.z(), centre.z}}};
    const std::array<double, 3> origin{first.x, first.y, first.z};
    for (std::size_t i = 0; i < 3; ++i) {
      const CGAL::Gmpq& expected = coordinates.at(i).first;
      const CGAL::Gmpq error = CGAL::abs(CGAL::Gmpq(coordinates.at(i).second) - expected);
      const CGAL::Gmpq away = CGAL::abs(expected - CGAL::Gmpq(origin.at(i)));
      const CGAL::Gmpq last_rounding = CGAL::abs(expected) * CGAL::Gmpq(0x1.1p-53);
      ASSERT_LE(error, last_rounding + away * CGAL::Gmpq(0x1p-51));
      if (error > last_rounding)
        worst = std::max(worst, CGAL::to_double((error - last_rounding) / away));
    }
  });
  testing::Test::RecordProperty("worst_in_units_of_2^-53", std::to_string(worst * 0x1p53));
}

}  // namespace
}  // namespace thiessen
