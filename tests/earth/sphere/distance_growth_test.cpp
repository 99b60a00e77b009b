// Bounds on how distances grow apart, which distance_growth.cpp derives.
#include <gtest/gtest.h>

#include <cmath>

#include "earth/random_points.h"
#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

// Whatever is within reach, the difference of the distances there is no less.
TEST(LeastDifference, holds_within_reach) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(4000); ++round) {
    const Point centre = random_point(seeded);
    const Point first = random_point_at(seeded, centre, seeded.uniform(0, 2e7));
    const Point second = round % 3 == 0
                             ? random_point(seeded)
                             : random_point_at(seeded, first, std::pow(10, seeded.uniform(0, 6.5)));
    const double reach = std::pow(10, seeded.uniform(0, 6));
    const double least = least_difference(arrival(first, centre), arrival(second, centre),
                                          geodesic_distance(first, second), reach);
    for (int i = 0; i < 10; ++i) {
      const Point p = random_point_at(seeded, centre, reach * (i < 7 ? 1 : seeded.uniform(0, 1)));
      const double difference = geodesic_distance(second, p) - geodesic_distance(first, p);
      ASSERT_GE(difference, least - 1e-7)
          << round << ": " << centre.x << " " << centre.y << ", reach " << reach;
    }
  }
}

// Two places a kilometre from each other, a sixth of the Earth away: their distances differ by the
// same, but for a thousandth, within 100 km.
TEST(LeastDifference, of_places_near_each_other_is_near_the_truth) {
  const Point centre{20, 40};
  const Point first = moved(centre, 6.6e6, 0);
  const Point beyond = moved(centre, 6.601e6, 0);
  const double apart = geodesic_distance(first, beyond);
  const double least =
      least_difference(arrival(first, centre), arrival(beyond, centre), apart, 100e3);
  EXPECT_NEAR(least, 1000, 10);
}

TEST(LeastDifference, beyond_all_bounds_knows_the_triangle) {
  const Arrival near{10, 1, 0};
  const Arrival far{2.00035e7, 0, 1};
  EXPECT_DOUBLE_EQ(least_difference(near, far, 2.0003e7, 1000), 2.00035e7 - 10 - 2000);
  EXPECT_DOUBLE_EQ(least_difference(near, far, 2.0003e7, 0), 2.00035e7 - 10);
}

}  // namespace
}  // namespace thiessen
