#include "earth/cells/chart_nearness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "earth/sphere/conformal_sphere.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

// The figure by its definition, with Karney's distance.
double expected(const GnomonicChart& chart, const EarthPoint& place, Point p) {
  const double metres = geodesic_distance(place.position, from_sphere(chart.direction(p)));
  const double sine = std::sin(metres / (2 * scale_on_earth(chart.centre().z)));
  const double slant = std::sqrt(1 + p.x * p.x + p.y * p.y);
  return 2 * slant * sine * sine - (p.x * p.x + p.y * p.y) / (slant + 1);
}

TEST(ChartNearness, is_that_of_geodesic_distances) {
  struct Case {
    double reach;
    double metres;
  };
  constexpr double earth = 6.37e6;
  Seeded seeded;
  for (const double latitude : {-80.0, -33.0, 0.0, 47.0, 89.9}) {
    for (const Case& c : {Case{0.002, 1e-6}, Case{0.004, 1e-5}, Case{0.005, 3e-5}}) {
      const GnomonicChart chart(on_sphere({5, latitude}));
      const ChartNearness nearness(chart, c.reach);
      for (int i = 0; i < 50; ++i) {
        const auto anywhere = [&](double within) {
          return Point{seeded.uniform(-within, within), seeded.uniform(-within, within)};
        };
        const EarthPoint place(chart.direction(anywhere(3 * c.reach)));
        const auto found = nearness.of(place);
        ASSERT_TRUE(found);
        const Point p = anywhere(c.reach);
        const double way = length(chart.direction(p) - place.direction);
        EXPECT_NEAR((found->at(p) - expected(chart, place, p)) / way * earth, 0, c.metres);
        EXPECT_LE(std::abs(found->bent_at(p)), found->most_bent);
      }
    }
  }
}

TEST(ChartNearness, is_nothing_of_places_far_away) {
  const ChartNearness nearness(GnomonicChart(on_sphere({5, 45})), 0.01);
  EXPECT_FALSE(nearness.of(EarthPoint(Point{50, 45})));
}

}  // namespace
}  // namespace thiessen
