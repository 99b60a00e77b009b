#include "rainfall/normals/pixel_mapping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

TEST(AffineMapping, of_a_raster_with_its_first_row_in_the_north) {
  // pixels of 10 by 5, the upper left corner at (100, 50)
  const AffineMapping mapping({-10, 10}, {0.1, 0}, {0, -0.2});
  EXPECT_EQ(mapping.to_pixels({100, 50}), (Point{0, 0}));
  EXPECT_EQ(mapping.to_pixels({115, 40}), (Point{1.5, 2}));
}

/// A conic projection of a kind: what matters is that it bends.
Point bent(Point p) {
  const double radius = 300 - p.y;
  return {radius * std::sin(p.x / 100), radius * std::cos(p.x / 100)};
}

TEST(SmoothMapping, is_as_near_as_it_is_asked_to_be) {
  Seeded seeded;
  const SmoothMapping mapping(
      [](std::vector<Point> points) {
        for (Point& p : points) p = bent(p);
        return points;
      },
      {{-30, 0}, {60, 40}}, 1e-6);
  EXPECT_LE(mapping.error(), 1e-6);
  for (int i = 0; i < 200; ++i) {
    const Point p{seeded.uniform(-30, 60), seeded.uniform(0, 40)};
    const Point found = mapping.to_pixels(p);
    EXPECT_NEAR(found.x, bent(p).x, 2e-6);
    EXPECT_NEAR(found.y, bent(p).y, 2e-6);
  }
}

TEST(SmoothMapping, tells_where_points_cannot_be_mapped) {
  const SmoothMapping mapping(
      [](std::vector<Point> points) {
        for (Point& p : points) {
          if (p.x > 50) p.x = std::numeric_limits<double>::quiet_NaN();
        }
        return points;
      },
      {{-30, 0}, {60, 40}}, 1e-6);
  EXPECT_TRUE(std::isnan(mapping.error()));
}

}  // namespace
}  // namespace thiessen
