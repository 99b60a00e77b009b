// Points of edges on the ellipsoid: judged by Karney's distances.
#include "earth/cells/geodesic_bisector.h"

#include <gtest/gtest.h>

#include <cmath>

#include "earth/random_points.h"
#include "earth/sphere/conformal_sphere.h"

namespace thiessen {
namespace {

constexpr double accuracy = 1e-6;  // metres

GeodesicBisector bisector(Point a, Point b) {
  const EarthPoint first(a);
  const EarthPoint second(b);
  return {first, second, {first.direction, second.direction}, accuracy};
}

TEST(GeodesicBisector, law_1_an_exact_point_is_as_far_from_both_places) {
  Seeded seeded;
  std::size_t exact = 0;
  for (std::uint64_t i = 0; i < Seeded::rounds(500); ++i) {
    const Point a = random_point(seeded);
    const Point b = random_point_at(seeded, a, std::pow(10, seeded.uniform(2, 6.5)));
    const BisectorPoint p = bisector(a, b).find(seeded.uniform(-1, 1));
    if (!p.is_exact) continue;
    ++exact;
    EXPECT_NEAR(geodesic_distance(a, p.position), geodesic_distance(b, p.position), 2 * accuracy);
  }
  EXPECT_GT(exact, 400u);
}

TEST(GeodesicBisector, law_2_it_is_no_farther_from_the_great_circle_than_it_may_be) {
  Seeded seeded;
  for (std::uint64_t i = 0; i < Seeded::rounds(500); ++i) {
    const Point a = random_point(seeded);
    const GeodesicBisector edge =
        bisector(a, random_point_at(seeded, a, std::pow(10, seeded.uniform(2, 6.5))));
    const double angle = seeded.uniform(-1, 1);
    const BisectorPoint p = edge.find(angle);
    EXPECT_LE(std::abs(p.offset), edge.farthest_off(std::abs(angle)));
    // Straight across: the angle stays.
    EXPECT_NEAR(edge.arc().angle_of(on_sphere(p.position)), angle, 1e-12);
  }
}

TEST(GeodesicBisector, law_3_where_the_search_begins_does_not_matter) {
  Seeded seeded;
  for (std::uint64_t i = 0; i < Seeded::rounds(200); ++i) {
    const Point a = random_point(seeded);
    const GeodesicBisector edge = bisector(a, random_point_at(seeded, a, 200'000));
    const double angle = seeded.uniform(-0.5, 0.5);
    const BisectorPoint p = edge.find(angle);
    const BisectorPoint q = edge.find(angle, p.offset + seeded.uniform(-1e-4, 1e-4));
    EXPECT_LT(geodesic_distance(p.position, q.position), 1e-4);
  }
}

TEST(GeodesicBisector, of_places_mirrored_by_the_equator_is_the_equator) {
  const GeodesicBisector edge = bisector({20, 3}, {20, -3});
  for (const double angle : {-1.0, -0.1, 0.0, 0.4, 1.2}) {
    const BisectorPoint p = edge.find(angle);
    EXPECT_NEAR(p.position.y, 0, 1e-11);
    EXPECT_NEAR(p.position.x, 20 + angle * 180 / M_PI, 1e-9);
  }
}

TEST(GeodesicBisector, of_places_mirrored_by_a_meridian_is_the_meridian) {
  const GeodesicBisector edge = bisector({8, 47}, {12, 47});
  for (const double angle : {-0.5, 0.0, 0.3, 0.6})
    EXPECT_NEAR(edge.find(angle).position.x, 10, 1e-10);
}

}  // namespace
}  // namespace thiessen
