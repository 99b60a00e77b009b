// The point as far from three places: judged by Karney's distances.
#include "earth/cells/equidistance.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "earth/random_points.h"
#include "earth/sphere/conformal_sphere.h"

namespace thiessen {
namespace {

TEST(EquidistantPoint, law_1_is_as_far_from_all_three_as_it_says) {
  Seeded seeded;
  std::size_t found = 0;
  for (std::uint64_t i = 0; i < Seeded::rounds(500); ++i) {
    const Point middle = random_point(seeded);
    const double metres = std::pow(10, seeded.uniform(3, 6));
    // Three places round the middle, no two of them in nearly one direction.
    std::array<Point, 3> places;
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * M_PI * (k + seeded.uniform(0, 0.6)) / 3;
      places[static_cast<std::size_t>(k)] =
          moved(middle, metres * std::sin(angle), metres * std::cos(angle));
    }
    const auto point = equidistant_point(EarthPoint(places[0]), EarthPoint(places[1]),
                                         EarthPoint(places[2]), on_sphere(middle), 1e-7);
    if (!point) continue;
    ++found;
    for (const Point p : places)
      EXPECT_NEAR(geodesic_distance(p, from_sphere(point->at)), point->radius, 3e-7);
    // They are as far from the middle on the ellipsoid.
    EXPECT_NEAR(point->radius, metres, 1e-6);
    EXPECT_LT(geodesic_distance(from_sphere(point->at), middle), 1e-5);
  }
  EXPECT_EQ(found, Seeded::rounds(500));
}

TEST(EquidistantPoint, law_2_the_order_of_the_places_matters_no_more_than_rounding) {
  const EarthPoint a(Point{8, 47});
  const EarthPoint b(Point{9, 46});
  const EarthPoint c(Point{10, 47.5});
  const Direction start = on_sphere({9, 47});
  const auto one = equidistant_point(a, b, c, start, 1e-7);
  const auto other = equidistant_point(c, a, b, start, 1e-7);
  ASSERT_TRUE(one && other);
  EXPECT_NEAR(one->radius, other->radius, 1e-6);
  EXPECT_LT(geodesic_distance(from_sphere(one->at), from_sphere(other->at)), 1e-6);
}

TEST(EquidistantPoint, of_three_places_round_a_pole_is_the_pole) {
  const auto point = equidistant_point(EarthPoint(Point{0, 80}), EarthPoint(Point{120, 80}),
                                       EarthPoint(Point{-120, 80}), on_sphere({30, 89}), 1e-7);
  ASSERT_TRUE(point);
  EXPECT_NEAR(from_sphere(point->at).y, 90, 1e-11);
}

}  // namespace
}  // namespace thiessen
