#include "earth/sphere/geodesic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "earth/random_points.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

TEST(Geodesic, arrives_along_the_path) {
  const Arrival from_west = arrival({0, 0}, {1, 0});
  EXPECT_NEAR(from_west.distance, 6378137 * M_PI / 180, 1e-8);
  EXPECT_NEAR(from_west.east, 1, 1e-15);
  EXPECT_NEAR(from_west.north, 0, 1e-15);
  const Arrival from_north = arrival({7, 50}, {7, -20});
  EXPECT_NEAR(from_north.north, -1, 1e-15);
}

// Whatever is within reach, the difference of the distances there is no less.
TEST(Geodesic, least_differences_hold_within_reach) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
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
TEST(Geodesic, least_differences_of_places_near_each_other_are_near_the_truth) {
  const Point centre{20, 40};
  const Point first = moved(centre, 6.6e6, 0);
  const Point beyond = moved(centre, 6.601e6, 0);
  const double apart = geodesic_distance(first, beyond);
  const double least =
      least_difference(arrival(first, centre), arrival(beyond, centre), apart, 100e3);
  EXPECT_NEAR(least, 1000, 10);
}

TEST(Geodesic, least_differences_beyond_all_bounds_know_the_triangle) {
  const Arrival near{10, 1, 0};
  const Arrival far{2.00035e7, 0, 1};
  EXPECT_DOUBLE_EQ(least_difference(near, far, 2.0003e7, 1000), 2.00035e7 - 10 - 2000);
  EXPECT_DOUBLE_EQ(least_difference(near, far, 2.0003e7, 0), 2.00035e7 - 10);
}

// Simpson's rule against Karney's distances, beyond where it is given up.
TEST(Geodesic, arrives_as_exactly_as_is_asked) {
  Seeded seeded;
  for (const double accuracy : {1e-6, 1e-5, 1e-3, 1e-2}) {
    for (std::uint64_t round = 0; round < seeded.rounds(3000); ++round) {
      const Point from = random_point(seeded);
      const Point to = random_point_at(seeded, from, std::pow(10, seeded.uniform(-2, 5.6)));
      const Arrival found = arrival(EarthPoint(from), EarthPoint(to), accuracy);
      const Arrival exact = arrival(from, to);
      EXPECT_NEAR(found.distance, exact.distance, accuracy / 10 + 2e-8);
      if (exact.distance < 1) continue;
      EXPECT_NEAR(found.east, exact.east, 1e-3);
      EXPECT_NEAR(found.north, exact.north, 1e-3);
    }
  }
}

}  // namespace
}  // namespace thiessen
