// Positions by series: judged by from_sphere, which has another way to the same.
#include "earth/sphere/nearby_positions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "earth/random_points.h"
#include "earth/sphere/conformal_sphere.h"

namespace thiessen {
namespace {

constexpr double rounding = 1e-13;  // degrees

void expect_same(Point found, Point expected) {
  EXPECT_NEAR(found.y, expected.y, rounding);
  EXPECT_NEAR(std::remainder(found.x - expected.x, 360) * std::cos(expected.y * M_PI / 180), 0,
              rounding);
}

TEST(NearbyPositions, law_1_are_those_of_the_sphere_near_and_far) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(5000); ++round) {
    const Point base = random_point(seeded);
    const Point p = random_point_at(seeded, base, std::pow(10, seeded.uniform(-3, 7)));
    expect_same(NearbyPositions(base, on_sphere(base)).of(on_sphere(p)), from_sphere(on_sphere(p)));
  }
}

TEST(NearbyPositions, law_2_are_in_the_turn_of_the_base) {
  const Point base{359.9, 40};
  const NearbyPositions near(base, on_sphere(base));
  EXPECT_NEAR(near.of(on_sphere({0.2, 40.1})).x, 360.2, rounding);
  EXPECT_NEAR(near.of(on_sphere({60, 40.1})).x, 420, rounding);
  EXPECT_NEAR(near.way_to(on_sphere({-0.5, 39})).x, -0.4, rounding);
}

TEST(NearbyPositions, law_3_are_right_at_and_round_poles) {
  for (const double latitude : {90.0, 89.999, 89.0, -90.0, -89.5}) {
    const Point base{30, latitude};
    const NearbyPositions near(base, on_sphere(base));
    for (const Point p :
         {Point{-150, latitude * 0.999}, Point{31, latitude * 0.99999}, Point{1, latitude * 0.999}})
      expect_same(near.of(on_sphere(p)), p);
  }
}

}  // namespace
}  // namespace thiessen
