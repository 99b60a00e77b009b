#include "earth/sphere/geodesic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "earth/random_points.h"
#include "earth/sphere/conformal_sphere.h"
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

TEST(Geodesic, short_paths_are_as_exact) {
  Seeded seeded;
  for (const double accuracy : {1e-7, 1e-6, 1e-3}) {
    std::size_t paths = 0;
    for (std::uint64_t round = 0; round < seeded.rounds(1000); ++round) {
      const Point from = random_point(seeded);
      const Point to = random_point_at(seeded, from, std::pow(10, seeded.uniform(0, 5)));
      const Direction a = on_sphere(from);
      const Direction b = on_sphere(to);
      const double half = length(b - a) / 2;
      if (!is_short_path(half, accuracy)) continue;
      ++paths;
      const double found =
          short_path(sphere_scale(), {a, scale_on_earth(a.z)}, {b, scale_on_earth(b.z)}, half);
      EXPECT_NEAR(found, geodesic_distance(from, to), accuracy / 10 + 2e-8);
    }
    EXPECT_GT(paths, seeded.rounds(500));
  }
}

}  // namespace
}  // namespace thiessen
