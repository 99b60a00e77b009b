// The great circle of points as far from two others.
#include "earth/sphere/bisector_arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "earth/random_points.h"
#include "earth/sphere/conformal_sphere.h"

namespace thiessen {
namespace {

constexpr double pi = std::numbers::pi;

struct Two {
  explicit Two(Seeded& seeded)
      : first(on_sphere(random_point(seeded))), second(on_sphere(random_point(seeded))) {}
  Direction first;
  Direction second;
};

double distance(Direction a, Direction b) {
  return length(a - b);
}

TEST(BisectorArc, law_1_is_as_far_from_both_with_the_first_on_its_left) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5000); ++round) {
    const auto [a, b] = Two(seeded);
    const BisectorArc arc(a, b);
    for (const double angle : {-3.0, -1.0, 0.0, 0.5, 2.0}) {
      const Direction p = arc.at(angle);
      ASSERT_NEAR(length(p), 1, 1e-15 + 1e-15 / length(a + b));
      ASSERT_NEAR(dot(p, a), dot(p, b), 1e-15 + 1e-15 / length(a + b));
      ASSERT_NEAR(arc.angle_of(p), angle, 1e-14 + 1e-15 / length(a + b));
      const Direction ahead = arc.at(angle + 0.1) - p;
      ASSERT_GT(dot(cross(p, ahead), a - b), 0);
    }
    ASSERT_GT(dot(arc.at(0), a + b), 0);
  }
}

TEST(BisectorArc, law_2_angle_0_is_the_middle_and_half_the_separation_away) {
  Seeded seeded;
  for (int i = 0; i < 200; ++i) {
    const Two two(seeded);
    const BisectorArc arc(two.first, two.second);
    EXPECT_NEAR(std::acos(dot(arc.at(0), two.first)), arc.half_separation(), 1e-7);
    EXPECT_NEAR(2 * std::asin(distance(two.first, two.second) / 2), 2 * arc.half_separation(),
                1e-15);
    // Everywhere else on it they are farther.
    EXPECT_GT(distance(arc.at(seeded.uniform(0.1, pi)), two.first), distance(arc.at(0), two.first));
  }
}

TEST(BisectorArc, law_3_angle_of_is_the_inverse_of_at) {
  Seeded seeded;
  for (int i = 0; i < 200; ++i) {
    const Two two(seeded);
    const BisectorArc arc(two.first, two.second);
    const double angle = seeded.uniform(-pi, pi);
    EXPECT_NEAR(arc.angle_of(arc.at(angle)), angle, 1e-14);
    EXPECT_NEAR(arc.angle_of(arc.at(angle, seeded.uniform(-0.5, 0.5))), angle, 1e-14);
  }
}

TEST(BisectorArc, law_4_going_on_it_the_first_is_on_the_left_and_offsets_lead_to_the_second) {
  Seeded seeded;
  for (int i = 0; i < 200; ++i) {
    const Two two(seeded);
    const BisectorArc arc(two.first, two.second);
    const double angle = seeded.uniform(-pi, pi);
    const Direction onward = arc.at(angle + 0.01) - arc.at(angle);
    const Direction left = cross(arc.at(angle), onward);
    EXPECT_GT(dot(left, two.first - two.second), 0);
    const Direction off = arc.at(angle, 0.01);
    EXPECT_LT(distance(off, two.second), distance(off, two.first));
    EXPECT_NEAR(distance(off, arc.at(angle)), 2 * std::sin(0.005), 1e-14);
    EXPECT_NEAR(dot(arc.across(angle, 0.01), off), 0, 1e-14);
    EXPECT_NEAR(dot(arc.across(angle, 0), arc.forward()), 1, 1e-14);
  }
}

TEST(BisectorArc, law_5_between_begins_at_the_start_and_goes_forward_by_less_than_a_turn) {
  Seeded seeded;
  for (int i = 0; i < 200; ++i) {
    const Two two(seeded);
    const BisectorArc arc(two.first, two.second);
    const double start = seeded.uniform(-pi, pi);
    const double way = seeded.uniform(0, pi);
    const auto [from, to] = arc.between(arc.at(start), arc.at(start + way));
    EXPECT_NEAR(from, start, 1e-14);
    EXPECT_NEAR(to - from, way, 1e-13);
    // A little backward is rounding.
    const auto [same, also] = arc.between(arc.at(start), arc.at(start - 1e-15));
    EXPECT_EQ(same, also);
  }
}

TEST(BisectorArc, of_antipodes_is_any_circle_across_their_axis) {
  for (const Direction pole : {Direction{0, 0, 1}, {1, 0, 0}, {0, 0.6, 0.8}}) {
    const BisectorArc arc(pole, -1 * pole);
    for (const double angle : {0.0, 1.0, -2.5}) {
      EXPECT_NEAR(dot(arc.at(angle), pole), 0, 1e-15);
      EXPECT_NEAR(length(arc.at(angle)), 1, 1e-15);
    }
  }
}

// Of (0, -10) and (0, 10) it is the equator, run to the west from the first to the second's left.
TEST(BisectorArc, of_mirrored_places_is_the_equator) {
  const BisectorArc arc(on_sphere({0, -10}), on_sphere({0, 10}));
  const Point p = from_sphere(arc.at(pi / 6));
  EXPECT_NEAR(p.x, -30, 1e-13);
  EXPECT_NEAR(p.y, 0, 1e-13);
}

}  // namespace
}  // namespace thiessen
