// Each stage of the predicates' arithmetic against the next ones.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "geometry/plane_families.h"
#include "geometry/predicates.h"
#include "geometry/space_families.h"
#include "geometry/space_predicates.h"
#include "geometry/stages.h"

namespace thiessen {
namespace {

using Four = std::array<SpacePoint, 4>;
using Five = std::array<SpacePoint, 5>;

int orientation_at_all_widths(Point a, Point b, Point c) {
  return sign_at_all_widths(std::array{a, b, c},
                            [](const auto& to) { return determinant::area(to[0], to[1]); });
}
Stage orientation_stage(Point a, Point b, Point c) {
  return stage_of<3, 2>(determinant::area(estimated_vector(c, a), estimated_vector(c, b)),
                        std::array{a, b, c}, a.x, a.y, b.x, b.y, c.x, c.y);
}

// Inputs made to reach each stage; the answers are worked out by hand.
TEST(OrientationStages, is_the_same_at_every_stage_from_the_first_that_answers) {
  struct Case {
    std::array<Point, 3> points;
    Stage stage;
    int side;
  };
  const double h = largest_coordinate;
  const double t = smallest_coordinate;
  const std::vector<Case> cases{
      {{{{0, 0}, {1, 0}, {0, 1}}}, Stage::rounded, 1},
      // Along an axis every term is zero.
      {{{{0.1, 0.3}, {0.7, 0.3}, {0.2, 0.3}}}, Stage::rounded, 0},
      {{{{500000, 4000000}, {500001, 4000003}, {500010, 4000030}}}, Stage::exact_doubles, 0},
      {{{{0, 0}, {0.25, 0.75}, {2.5, 7.5}}}, Stage::exact_doubles, 0},
      // 2^-51 beside two terms of 1: less than three roundings.
      {{{{0x1.0000000000001p0, 0x1.ffffffffffffep-1}, {0x1p0, 0x1p0}, {0, 0}}}, Stage::one_limb, 1},
      {{{{1, 1}, {-1, -1}, {0x1p-70, 0x1.0000000000001p-70}}}, Stage::two_limbs, -1},
      {{{{h, h}, {-h, -h}, {0, t}}}, Stage::seven_limbs, -1},
      {{{{h, h}, {-h, -h}, {t, t}}}, Stage::seven_limbs, 0}};
  for (const auto& [p, stage, side] : cases) {
    SCOPED_TRACE(stage);
    EXPECT_EQ(orientation_stage(p[0], p[1], p[2]), stage);
    EXPECT_EQ(orientation(p[0], p[1], p[2]), side);
    EXPECT_EQ(orientation_at_all_widths(p[0], p[1], p[2]), side);
  }
}

// Doubles from -2^52 to -2^51 are half units. Whether a coordinate is whole is asked with a sum, in
// which that half must not get lost.
TEST(OrientationStages, is_exact_among_half_units_far_below_zero) {
  Seeded seeded;
  std::array<int, 5> reached{};
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const auto half_units = [&seeded](std::int64_t size) {
      return 0.5 * static_cast<double>(seeded.whole(-size, size));
    };
    const Point step{half_units(1 << 26), half_units(1 << 26)};
    const Point a{-0x1.8p51, -0x1.4p51};
    const Point b{a.x + step.x, a.y + step.y};
    const Point c{b.x + step.x + half_units(2), b.y + step.y + half_units(2)};
    ++reached.at(static_cast<std::size_t>(orientation_stage(a, b, c)));
    ASSERT_EQ(orientation(a, b, c), orientation_at_all_widths(a, b, c));
  }
  for (const Stage stage : {Stage::rounded, Stage::exact_doubles, Stage::one_limb})
    EXPECT_GT(reached.at(static_cast<std::size_t>(stage)), 100) << stage;
}

TEST(OrientationStages, of_any_points_is_that_of_seven_limbs) {
  Seeded seeded;
  std::array<int, 5> reached{};
  for (std::uint64_t round = 0; round < seeded.rounds(50000); ++round) {
    const auto [a, b, c, d] = random_corners(seeded);
    ++reached.at(static_cast<std::size_t>(orientation_stage(a, b, c)));
    ASSERT_EQ(orientation(a, b, c), orientation_at_all_widths(a, b, c));
  }
  for (const int times : reached) EXPECT_GT(times, 50);
}

int in_circle_at_all_widths(const Corners& p) {
  return sign_at_all_widths(
      p, [](const auto& to) { return determinant::in_circle(to[0], to[1], to[2]); });
}
Stage in_circle_stage(const Corners& p) {
  const auto& [a, b, c, d] = p;
  return stage_of<10, 4>(estimated_lift(a, b, c, d), p, a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y);
}

TEST(InCircleStages, is_the_same_at_every_stage_from_the_first_that_answers) {
  struct Case {
    Corners points;
    Stage stage;
    int side;
  };
  const double h = largest_coordinate;
  const double t = smallest_coordinate;
  const double beside_1 = std::nextafter(1, 2);
  const std::vector<Case> cases{
      {{{{0, 0}, {1, 0}, {0, 1}, {0.25, 0.25}}}, Stage::rounded, 1},
      // A corner again: every term is zero.
      {{{{0.1, 0.2}, {0.9, 0.3}, {0.4, 0.7}, {0.9, 0.3}}}, Stage::rounded, 0},
      {{{{500000, 4000000}, {500003, 4000000}, {500003, 4000004}, {500000, 4000004}}},
       Stage::exact_doubles,
       0},
      {{{{500000.1, 4000000.3},
         {500000.7, 4000000.3},
         {500000.7, 4000000.4},
         {500000.1, 4000000.4}}},
       Stage::one_limb,
       0},
      {{{{0, 0}, {1, 0}, {0, 1}, {1, beside_1}}}, Stage::one_limb, -1},
      {{{{-1, -0x1p-70}, {1, -0x1p-70}, {1, 0x1p-70}, {-1, 0x1p-70}}}, Stage::two_limbs, 0},
      {{{{-1, -0x1p-70}, {1, -0x1p-70}, {beside_1, 0x1p-70}, {-1, 0x1p-70}}}, Stage::two_limbs, 1},
      {{{{-h, 0}, {h, 0}, {0, h}, {t, -h}}}, Stage::seven_limbs, -1},
      {{{{-h, -t}, {h, -t}, {h, t}, {-h, t}}}, Stage::seven_limbs, 0}};
  for (const auto& [p, stage, side] : cases) {
    SCOPED_TRACE(stage);
    EXPECT_EQ(in_circle_stage(p), stage);
    EXPECT_EQ(in_circle(p[0], p[1], p[2], p[3]), side);
    EXPECT_EQ(in_circle_at_all_widths(p), side);
  }
}

TEST(InCircleStages, of_any_points_is_that_of_seven_limbs) {
  Seeded seeded;
  std::array<int, 5> reached{};
  for (std::uint64_t round = 0; round < seeded.rounds(50000); ++round) {
    const Corners p = random_corners(seeded);
    ++reached.at(static_cast<std::size_t>(in_circle_stage(p)));
    ASSERT_EQ(in_circle(p[0], p[1], p[2], p[3]), in_circle_at_all_widths(p));
  }
  for (const int times : reached) EXPECT_GT(times, 50);
}

TEST(CompareDistanceStages, is_exact_at_every_stage) {
  const double h = largest_coordinate;
  const double t = smallest_coordinate;
  const double beside_1 = std::nextafter(1, 2);
  struct Case {
    std::array<Point, 3> points;
    Stage stage;
    int nearer;
  };
  const std::vector<Case> cases{
      {{{{0, 0}, {1, 0}, {0, 2}}}, Stage::rounded, -1},
      {{{{500000, 4000000}, {500003, 4000004}, {500005, 4000000}}}, Stage::exact_doubles, 0},
      {{{{0.1, 0.1}, {0.1, 0.2}, {0.2, 0.1}}}, Stage::one_limb, 0},
      {{{{0, 0}, {1, 1}, {1, beside_1}}}, Stage::one_limb, -1},
      {{{{0, 0}, {1, 0x1p-65}, {-1, 0}}}, Stage::two_limbs, 1},
      {{{{0, t}, {h, 0}, {-h, -t}}}, Stage::seven_limbs, -1}};
  for (const auto& [p, stage, nearer] : cases) {
    SCOPED_TRACE(stage);
    const auto& [from, a, b] = p;
    const Estimate estimate = determinant::square(estimated_vector(from, a)) -
                              determinant::square(estimated_vector(from, b));
    EXPECT_EQ(
        (stage_of<4, 2>(estimate, std::array{a, b, from}, from.x, from.y, a.x, a.y, b.x, b.y)),
        stage);
    EXPECT_EQ(compare_distance(from, a, b), nearer);
    EXPECT_EQ(sign_at_all_widths(std::array{a, b, from},
                                 [](const auto& to) {
                                   return determinant::square(to[0]) - determinant::square(to[1]);
                                 }),
              nearer);
  }
}

Stage orientation_stage(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                        const SpacePoint& d) {
  return stage_of<7, 3>(
      determinant::volume(estimated_vector(a, b), estimated_vector(a, c), estimated_vector(a, d)),
      Four{b, c, d, a}, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z);
}
int orientation_at_all_widths(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                              const SpacePoint& d) {
  return sign_at_all_widths(
      Four{b, c, d, a}, [](const auto& to) { return determinant::volume(to[0], to[1], to[2]); });
}

// Inputs made to reach each stage; the answers are worked out by hand.
TEST(SpaceOrientationStages, is_the_same_at_every_stage_from_the_first_that_answers) {
  struct Case {
    Four points;
    Stage stage;
    int side;
  };
  const double h = largest_coordinate;
  const double t = smallest_coordinate;
  const std::vector<Case> cases{
      {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, Stage::rounded, 1},
      // In a plane across an axis every term is zero.
      {{{{0.1, 0.3, 7.1}, {0.7, 0.2, 7.1}, {0.2, 0.5, 7.1}, {0.4, 0.4, 7.1}}}, Stage::rounded, 0},
      {{{{500000, 4000000, 7}, {500001, 4000000, 8}, {500000, 4000001, 9}, {500003, 4000002, 14}}},
       Stage::exact_doubles,
       0},
      {{{{0.1, 0.1, 0.1}, {0.7, 0.7, 0.2}, {0.3, 0.3, 0.9}, {0.6, 0.6, 0.4}}}, Stage::one_limb, 0},
      {{{{0, 0, 0}, {0x1.0000000000001p0, 0x1.ffffffffffffep-1, 0}, {1, 1, 0}, {1, 1, 1}}},
       Stage::one_limb,
       1},
      {{{{1, 1, 1}, {-1, -1, 1}, {1, 1, -1}, {0, 0x1p-70, 0}}}, Stage::two_limbs, -1},
      {{{{h, h, h}, {-h, -h, h}, {h, h, -h}, {0, t, 0}}}, Stage::seven_limbs, -1},
      {{{{h, h, h}, {-h, -h, h}, {h, h, -h}, {t, t, t}}}, Stage::seven_limbs, 0}};
  for (const auto& [p, stage, side] : cases) {
    SCOPED_TRACE(stage);
    EXPECT_EQ(orientation_stage(p[0], p[1], p[2], p[3]), stage);
    EXPECT_EQ(orientation(p[0], p[1], p[2], p[3]), side);
    EXPECT_EQ(orientation_at_all_widths(p[0], p[1], p[2], p[3]), side);
  }
}

TEST(SpaceOrientationStages, of_any_points_is_that_of_seven_limbs) {
  std::array<int, 5> reached{};
  for_all_families(30000, [&](const Five& p) {
    ++reached.at(static_cast<std::size_t>(orientation_stage(p[0], p[1], p[2], p[3])));
    ASSERT_EQ(orientation(p[0], p[1], p[2], p[3]),
              orientation_at_all_widths(p[0], p[1], p[2], p[3]));
  });
  for (const int times : reached) EXPECT_GT(times, 50);
}

/// In in_sphere the cheap bound comes first and the true one later.
Stage in_sphere_stage(const Five& p) {
  const auto& [a, b, c, d, e] = p;
  const Estimate quick = quick_lift(a, b, c, d, e);
  return stage_of<15, 5>(quick, p, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x,
                         e.y, e.z);
}
Estimate lift_of(const Five& p) {
  return estimated_lift(p[0], p[1], p[2], p[3], p[4]);
}
int in_sphere_at_all_widths(const Five& p) {
  return sign_at_all_widths(
      p, [](const auto& to) { return determinant::in_sphere(to[0], to[1], to[2], to[3]); });
}

TEST(InSphereStages, is_the_same_at_every_stage_from_the_first_that_answers) {
  struct Case {
    Five points;
    Stage stage;
    int side;
  };
  const double h = largest_coordinate;
  const double t = smallest_coordinate;
  const auto cuboid = [](SpacePoint low, SpacePoint high) {
    return Five{low, {high.x, low.y, low.z}, {low.x, high.y, low.z}, {low.x, low.y, high.z}, high};
  };
  const auto raised = [](Five p, double z) {
    p[4].z = z;
    return p;
  };
  const std::vector<Case> cases{
      {raised(cuboid({0, 0, 0}, {1, 1, 1}), 0.25), Stage::rounded, 1},
      {cuboid({500000, 4000000, -3}, {500001, 4000002, 1}), Stage::exact_doubles, 0},
      {cuboid({500000.1, 4000000.3, 0.1}, {500000.7, 4000000.4, 0.3}), Stage::one_limb, 0},
      {raised(cuboid({0, 0, 0}, {1, 1, 1}), std::nextafter(1, 2)), Stage::one_limb, -1},
      {raised(cuboid({0, 0, 0}, {1, 1, 1}), std::nextafter(1, 0)), Stage::one_limb, 1},
      {cuboid({-1, -0x1p-70, 0.5}, {1, 0x1p-70, 0.75}), Stage::two_limbs, 0},
      {cuboid({-h, -t, -h}, {h, t, h}), Stage::seven_limbs, 0},
      {raised(cuboid({-h, -t, -h}, {h, t, h}), std::nextafter(h, 0)), Stage::seven_limbs, 1}};
  for (const auto& [p, stage, side] : cases) {
    SCOPED_TRACE(stage);
    EXPECT_EQ(in_sphere_stage(p), stage);
    EXPECT_EQ(in_sphere(p[0], p[1], p[2], p[3], p[4]), side);
    EXPECT_EQ(in_sphere_at_all_widths(p), side);
  }
}

// One far corner makes the cheap bound too large by the cube of its distance.
TEST(InSphereStages, is_decided_by_the_true_bound_where_the_cheap_one_is_too_large) {
  const Five p{{{1e7, 1e7, 1e7}, {0, 1, 0}, {0.7, 0, 0}, {0, 0, 1.2}, {0.9, 0.5, 0.3}}};
  ASSERT_EQ(orientation(p[0], p[1], p[2], p[3]), 1);
  EXPECT_GT(in_sphere_stage(p), Stage::exact_doubles);
  EXPECT_TRUE(lift_of(p).is_certain_after<15>());
  EXPECT_EQ(lift_of(p).sign(), in_sphere_at_all_widths(p));
  EXPECT_EQ(in_sphere(p[0], p[1], p[2], p[3], p[4]), in_sphere_at_all_widths(p));
}

TEST(InSphereStages, of_any_points_is_that_of_seven_limbs) {
  std::array<int, 5> reached{};
  int by_the_true_bound = 0;
  for_all_families(30000, [&](const Five& p) {
    const Stage stage = in_sphere_stage(p);
    ++reached.at(static_cast<std::size_t>(stage));
    const Estimate lift = lift_of(p);
    by_the_true_bound +=
        static_cast<int>(stage > Stage::exact_doubles && lift.is_certain_after<15>());
    const int side = in_sphere_at_all_widths(p);
    ASSERT_EQ(in_sphere(p[0], p[1], p[2], p[3], p[4]), side);
    if (lift.is_certain_after<15>()) {
      ASSERT_EQ(lift.sign(), side);
    }
  });
  for (const int times : reached) EXPECT_GT(times, 50);
  EXPECT_GT(by_the_true_bound, 50);
}

}  // namespace
}  // namespace thiessen
