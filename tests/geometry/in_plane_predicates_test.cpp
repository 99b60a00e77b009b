// The predicates of points in a plane in space.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/seeded.h"
#include "geometry/space_families.h"
#include "geometry/space_predicates.h"

namespace thiessen {
namespace {

using Four = std::array<SpacePoint, 4>;

constexpr std::array axes{Axis::x, Axis::y, Axis::z};

TEST(AreCollinear, where_no_projection_spans_an_area) {
  EXPECT_TRUE(are_collinear({0, 0, 0}, {1, 2, 3}, {3, 6, 9}));
  EXPECT_TRUE(are_collinear({0, 0, 0}, {1, 2, 3}, {1, 2, 3}));
  EXPECT_TRUE(are_collinear({1, 2, 3}, {1, 2, 4}, {1, 2, 1e60}));
  EXPECT_FALSE(are_collinear({0, 0, 0}, {1, 2, 3}, {3, 6, std::nextafter(9, 10)}));
  EXPECT_FALSE(are_collinear({0, 0, 0}, {1, 2, 3}, {3, std::nextafter(6, 10), 9}));
  EXPECT_FALSE(are_collinear({0, 0, 0}, {1, 0, 0}, {1e60, 0, smallest_coordinate}));
}

TEST(ProjectionAxis, is_the_first_along_which_the_plane_does_not_get_flat) {
  const SpacePoint o{0, 0, 0};
  EXPECT_EQ(projection_axis(o, {1, 2, 3}, {3, 2, 2}), Axis::x);
  EXPECT_EQ(projection_axis(o, {0, 0, 1}, {0, 1, 0}), Axis::x);
  EXPECT_EQ(projection_axis(o, {0, 0, 1}, {1, 0, 0}), Axis::y);  // holds the x axis
  EXPECT_EQ(projection_axis(o, {1, 1, 0}, {1, 2, 0}), Axis::z);  // holds the x and y axes
  EXPECT_EQ(projection_axis({0, 0, 7}, {1, 0, 7}, {0, 1, 7}), Axis::z);
}

TEST(OrientationInPlane, is_that_of_the_projections_as_their_axis_sees_them) {
  const SpacePoint x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  for (const Axis axis : axes) {
    EXPECT_EQ(orientation_in_plane(axis, x, y, z), 1);
    EXPECT_EQ(orientation_in_plane(axis, y, x, z), -1);
  }
  EXPECT_EQ(orientation_in_plane(Axis::z, {0, 0, 5}, {1, 0, 9}, {0, 1, -7}), 1);
  EXPECT_EQ(orientation_in_plane(Axis::x, {0, 0, 5}, {1, 0, 9}, {0, 0, -7}), 0);
}

TEST(InCircleInPlane, is_inside_outside_or_on_it) {
  // A circle in the plane x + y + z = 1, through the axes' unit points; its centre is their
  // mean, and the sum of squares is 1 on it.
  const SpacePoint x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  for (const Axis axis : axes) {
    EXPECT_EQ(in_circle_in_plane(axis, x, y, z, {0.25, 0.25, 0.5}), 1);
    EXPECT_EQ(in_circle_in_plane(axis, x, y, z, {-1, 1, 1}), -1);
    EXPECT_EQ(in_circle_in_plane(axis, x, y, z, {-0.25, 0.25, 1}), -1);
    EXPECT_EQ(in_circle_in_plane(axis, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {-1, 2, 2}), 0);
  }
}

// Round a convex quadrilateral the answers alternate, however near it is to a circle.
TEST(InCircleInPlane, changes_its_sign_round_a_convex_quadrilateral) {
  Seeded seeded;
  int convex = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(40000); ++round) {
    const Four p = coplanar_points(seeded);
    if (!are_different(p) || are_collinear(p[0], p[1], p[2])) continue;
    const Axis axis = projection_axis(p[0], p[1], p[2]);
    const auto turns_left = [&](std::size_t i) {
      return orientation_in_plane(axis, p.at(i), p.at((i + 1) % 4), p.at((i + 2) % 4)) > 0;
    };
    if (!turns_left(0) || !turns_left(1) || !turns_left(2) || !turns_left(3)) continue;
    ++convex;
    ASSERT_EQ(in_circle_in_plane(axis, p[1], p[2], p[3], p[0]),
              -in_circle_in_plane(axis, p[0], p[1], p[2], p[3]));
    ASSERT_NE(in_perturbed_circle_in_plane(axis, p[1], p[2], p[3], p[0]),
              in_perturbed_circle_in_plane(axis, p[0], p[1], p[2], p[3]));
  }
  EXPECT_GT(convex, 1000);
}

TEST(InCircleInPlane, laws_1_and_2_no_even_permutation_and_no_axis_changes_it) {
  Seeded seeded;
  int on_circle = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    Four p = coplanar_points(seeded);
    if (!are_different(p) || are_collinear(p[0], p[1], p[2])) continue;
    const Axis first = projection_axis(p[0], p[1], p[2]);
    if (orientation_in_plane(first, p[0], p[1], p[2]) < 0) std::swap(p[0], p[1]);
    const auto& [a, b, c, d] = p;
    const int side = in_circle_in_plane(first, a, b, c, d);
    const bool inside = in_perturbed_circle_in_plane(first, a, b, c, d);
    on_circle += static_cast<int>(side == 0);
    for (const Axis axis : axes) {
      const int turn = orientation_in_plane(axis, a, b, c);
      if (turn == 0) continue;
      const SpacePoint& s = turn > 0 ? a : b;
      const SpacePoint& t = turn > 0 ? b : a;
      ASSERT_EQ(in_circle_in_plane(axis, s, t, c, d), side);
      ASSERT_EQ(in_circle_in_plane(axis, t, c, s, d), side);
      ASSERT_EQ(in_perturbed_circle_in_plane(axis, s, t, c, d), inside);
      ASSERT_EQ(in_perturbed_circle_in_plane(axis, t, c, s, d), inside);
    }
  }
  EXPECT_GT(on_circle, 1000);
}

TEST(InPerturbedCircleInPlane, law_3_is_that_of_any_sphere_through_its_circle) {
  Seeded seeded;
  int on_circle = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    Four p = coplanar_points(seeded);
    if (!are_different(p) || are_collinear(p[0], p[1], p[2])) continue;
    const Axis axis = projection_axis(p[0], p[1], p[2]);
    if (orientation_in_plane(axis, p[0], p[1], p[2]) < 0) std::swap(p[0], p[1]);
    const auto& [a, b, c, d] = p;
    on_circle += static_cast<int>(in_circle_in_plane(axis, a, b, c, d) == 0);
    const bool inside = in_perturbed_circle_in_plane(axis, a, b, c, d);
    const auto offset = [&seeded] { return static_cast<double>(seeded.whole(-4, 4)); };
    const SpacePoint apex{a.x + offset(), a.y + offset(), a.z + offset()};
    const int side = orientation(a, b, c, apex);
    if (side > 0) {
      ASSERT_EQ(in_perturbed_sphere(a, b, c, apex, d), inside);
    }
    if (side < 0) {
      ASSERT_EQ(in_perturbed_sphere(b, a, c, apex, d), inside);
    }
  }
  EXPECT_GT(on_circle, 1000);
}

TEST(InPerturbedCircleInPlane, across_an_axis_is_in_perturbed_circle) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5000); ++round) {
    std::array<Point, 4> p;
    for (Point& q : p)
      q = {static_cast<double>(seeded.whole(0, 2)), static_cast<double>(seeded.whole(0, 2))};
    if (orientation(p[0], p[1], p[2]) < 0) std::swap(p[0], p[1]);
    const auto raised = [](Point q) { return SpacePoint{q.x, q.y, 0.3}; };
    const Four r{raised(p[0]), raised(p[1]), raised(p[2]), raised(p[3])};
    if (orientation(p[0], p[1], p[2]) == 0 || !are_different(r)) continue;
    ASSERT_EQ(in_perturbed_circle_in_plane(Axis::z, r[0], r[1], r[2], r[3]),
              in_perturbed_circle(p[0], p[1], p[2], p[3]));
  }
}

}  // namespace
}  // namespace thiessen
