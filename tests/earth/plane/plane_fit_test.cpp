#include "earth/plane/plane_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace thiessen {
namespace {

std::vector<Point> grid(double west, double south, double east, double north, int count = 12) {
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i) {
    for (int j = 0; j <= count; ++j)
      points.push_back({west + (east - west) * i / count, south + (north - south) * j / count});
  }
  return points;
}

ProjectionKind kind_for(const std::vector<Point>& points) {
  return fit_plane(points)->plane.parameters().kind;
}

TEST(PlaneFit, a_study_along_a_meridian_gets_a_transverse_mercator) {
  const StudyPlane fitted = *fit_plane(grid(-71.5, -40, -70.5, -20));
  EXPECT_EQ(fitted.plane.parameters().kind, ProjectionKind::transverse_mercator);
  EXPECT_EQ(fitted.plane.parameters().longitude, -71);
  // The scale's excess at half a degree from the meridian is a half of (that angle times the cosine
  // of the latitude nearest to the equator) squared; k_0 halves it.
  const double angle = 0.5 * std::acos(-1.0) / 180 * std::cos(20 * std::acos(-1.0) / 180);
  EXPECT_NEAR(fitted.scale_error, angle * angle / 4, 0.02 * angle * angle);
}

TEST(PlaneFit, a_study_along_a_parallel_gets_a_conic) {
  const StudyPlane fitted = *fit_plane(grid(-105, 38, -75, 40));
  EXPECT_EQ(fitted.plane.parameters().kind, ProjectionKind::lambert_conformal);
  EXPECT_EQ(fitted.plane.parameters().longitude, -90);
  // Straight lines along the northern edge reach atan(tan 40 / cos 15) = 40.98 degrees.
  EXPECT_NEAR(fitted.plane.parameters().latitude, (38 + 40.98) / 2, 0.05);
}

TEST(PlaneFit, a_study_along_the_equator_gets_mercators_cylinder) {
  const StudyPlane fitted = *fit_plane(grid(-80, -1.2, -50, 1.2));
  EXPECT_EQ(fitted.plane.parameters().kind, ProjectionKind::lambert_conformal);
  EXPECT_EQ(fitted.plane.parameters().latitude, 0);
}

TEST(PlaneFit, round_a_pole_it_is_stereographic) {
  EXPECT_EQ(kind_for(grid(-180, 75, 180, 88)), ProjectionKind::polar_stereographic);
  EXPECT_EQ(fit_plane(grid(-180, -90, 180, -80))->plane.parameters().latitude, -90);
}

TEST(PlaneFit, the_antimeridian_is_no_border) {
  const StudyPlane here = *fit_plane(grid(-1, 50, 1, 60));
  std::vector<Point> there = grid(179, 50, 181, 60);
  for (Point& p : there) p.x = std::remainder(p.x, 360);
  const StudyPlane fitted = *fit_plane(there);
  EXPECT_EQ(std::abs(fitted.plane.parameters().longitude), 180);
  EXPECT_EQ(fitted.plane.parameters().scale, here.plane.parameters().scale);
  EXPECT_NEAR(fitted.scale_error, here.scale_error, 1e-12);
}

TEST(PlaneFit, a_hemisphere_and_the_whole_earth_have_no_sensible_plane) {
  const auto hemisphere = fit_plane(grid(-180, 0, 180, 90));
  ASSERT_TRUE(hemisphere);
  EXPECT_GT(hemisphere->scale_error, largest_scale_error);
  const auto earth = fit_plane(grid(-180, -90, 180, 90));
  EXPECT_TRUE(!earth || earth->scale_error > largest_scale_error);
  EXPECT_FALSE(fit_plane({}));
}

TEST(PlaneFit, a_single_point_and_points_at_a_pole_alone) {
  EXPECT_LT(fit_plane(std::vector<Point>{{10.2, 47.3}})->scale_error, 1e-8);
  EXPECT_LT(fit_plane(std::vector<Point>{{10, 90}, {170, 90}})->scale_error, 1e-8);
}

TEST(PlaneFit, the_order_of_points_does_not_matter) {
  std::mt19937 random(11);
  std::vector<Point> points = grid(3, 44, 19, 51);
  const std::string text = fit_plane(points)->plane.proj_text();
  for (int i = 0; i < 5; ++i) {
    std::shuffle(points.begin(), points.end(), random);
    EXPECT_EQ(fit_plane(points)->plane.proj_text(), text);
  }
}

/// A study of random size and place.
std::vector<Point> random_study(std::mt19937& random) {
  std::uniform_real_distribution<double> any(0, 1);
  const double size = std::pow(10.0, -2 + 3.3 * any(random));
  const double longitude = 360 * any(random) - 180;
  const double latitude = 170 * any(random) - 85;
  std::vector<Point> points;
  for (int i = 0; i < 40; ++i) {
    const double x = longitude + 2 * size * (any(random) - 0.5);
    const double y = latitude + size * (any(random) - 0.5);
    points.push_back({x, std::clamp(y, -90.0, 90.0)});
  }
  return points;
}

TEST(PlaneFit, no_scale_between_points_of_the_study_is_worse_than_told) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::size_t> which(0, 39);
  std::uniform_real_distribution<double> any(0, 1);
  for (int study = 0; study < 300; ++study) {
    const std::vector<Point> points = random_study(random);
    const auto fitted = fit_plane(points);
    if (!fitted || fitted->scale_error > largest_scale_error) continue;
    double worst = 0;
    for (int i = 0; i < 500; ++i) {
      const Point a = fitted->plane.forward(points[which(random)]);
      const Point b = fitted->plane.forward(points[which(random)]);
      const double share = any(random);
      const Point at =
          fitted->plane.reverse({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
      worst = std::max(worst, std::abs(fitted->plane.scale_at(at) - 1));
    }
    EXPECT_LE(worst, 1.02 * fitted->scale_error + 2e-9)
        << "study " << study << ": " << fitted->plane.proj_text();
  }
}

TEST(PlaneFit, no_other_meridian_parallel_or_scale_is_better) {
  std::mt19937 random(19);
  for (int study = 0; study < 60; ++study) {
    const std::vector<Point> points = random_study(random);
    const auto fitted = fit_plane(points);
    if (!fitted || fitted->scale_error > 0.05) continue;
    const auto worst_of = [&](PlaneParameters parameters) {
      const ConformalPlane plane(parameters);
      double worst = 0;
      for (const Point p : points) worst = std::max(worst, std::abs(plane.scale_at(p) - 1));
      return worst;
    };
    PlaneParameters other = fitted->plane.parameters();
    const double step = std::sqrt(fitted->scale_error) * 10;  // degrees
    for (const double by : {-step, step}) {
      PlaneParameters turned = other;
      (other.kind == ProjectionKind::transverse_mercator ? turned.longitude : turned.latitude) +=
          by;
      if (other.kind == ProjectionKind::polar_stereographic) continue;
      EXPECT_GT(worst_of(turned), 0.9 * fitted->scale_error) << fitted->plane.proj_text();
    }
  }
}

}  // namespace
}  // namespace thiessen
