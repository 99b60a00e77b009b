#include "files/plane/plane_mapping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "earth/plane/plane_fit.h"

namespace thiessen {
namespace {

TEST(PlaneMapping, law_1_geographiclib_agrees_with_proj_to_a_micrometre) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  int fitted_planes = 0;
  for (int study = 0; study < 120; ++study) {
    const double size = std::pow(10.0, -2 + 3.6 * any(random));
    const Point centre{360 * any(random) - 180, 178 * any(random) - 89};
    std::vector<Point> points;
    for (int i = 0; i < 60; ++i) {
      const double y = centre.y + size * (any(random) - 0.5);
      points.push_back({centre.x + 2 * size * (any(random) - 0.5), std::clamp(y, -90.0, 90.0)});
    }
    const auto fitted = fit_plane(points);
    if (!fitted || fitted->scale_error > largest_scale_error) continue;
    ++fitted_planes;
    const std::string text = fitted->plane.proj_text();
    const Transformation by_proj(Crs::wgs84(), Crs::from_text(text, "plane"));
    std::vector<Point> there = points;
    by_proj.apply_unproved(there);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point here = fitted->plane.forward(points[i]);
      EXPECT_LT(std::hypot(here.x - there[i].x, here.y - there[i].y), 1e-6)
          << text << " at " << points[i].x << " " << points[i].y;
    }
  }
  EXPECT_GT(fitted_planes, 80);
}

TEST(PlaneMapping, goes_by_way_of_the_files_own_crs) {
  const ConformalPlane plane({ProjectionKind::transverse_mercator, 15, 0, 0.9996});
  const PlaneMapping mapping(Crs::from_text("EPSG:32633", "x"), Crs::wgs84(), plane);
  std::vector<Point> points = {{500000, 5500000}, {450000.5, 5600000.25}};
  const std::vector<bool> inside = mapping.apply(points);
  EXPECT_TRUE(inside[0] && inside[1]);
  EXPECT_NEAR(points[0].x, 0, 1e-6);
  EXPECT_NEAR(points[0].y, 5500000, 1e-6);
  EXPECT_NEAR(points[1].x, -49999.5, 1e-6);
}

TEST(PlaneMapping, what_is_not_on_the_earth_lies_outside) {
  const ConformalPlane plane({ProjectionKind::polar_stereographic, 0, 90, 1});
  const PlaneMapping mapping(Crs::wgs84(), Crs::wgs84(), plane);
  std::vector<Point> points = {{10, 80}, {10, 95}, {10, -91}};
  const std::vector<bool> inside = mapping.apply(points);
  EXPECT_TRUE(inside[0]);
  EXPECT_FALSE(inside[1]);
  EXPECT_FALSE(inside[2]);
}

}  // namespace
}  // namespace thiessen
