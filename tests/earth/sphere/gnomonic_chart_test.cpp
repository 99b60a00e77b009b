#include "earth/sphere/gnomonic_chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "earth/area/ellipsoid_area.h"
#include "earth/random_points.h"
#include "earth/sphere/conformal_sphere.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

/// The area of a ring in longitude and latitude.
double area_on_ellipsoid(const std::vector<Point>& ring) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    area -= area_under(ring[i], ring[(i + 1) % ring.size()], ring[0].y);
  return area;
}

TEST(GnomonicChart, takes_directions_there_and_back) {
  Seeded seeded;
  for (std::uint64_t i = 0; i < Seeded::rounds(2000); ++i) {
    const Point centre = random_point(seeded);
    const GnomonicChart chart(on_sphere(centre));
    const Direction p = on_sphere(random_point_at(seeded, centre, seeded.uniform(0, 3e6)));
    const Point in_chart = chart.project(p);
    EXPECT_NEAR(length(chart.direction(in_chart) - p), 0, 1e-15);
    EXPECT_NEAR(std::hypot(in_chart.x, in_chart.y), std::tan(std::acos(dot(p, chart.centre()))),
                1e-6);
  }
}

// As long as nothing turns about.
TEST(GnomonicChart, keeps_counter_clockwise_and_great_circles_straight) {
  Seeded seeded;
  for (std::uint64_t i = 0; i < Seeded::rounds(2000); ++i) {
    const Point centre = random_point(seeded);
    const GnomonicChart chart(on_sphere(centre));
    const Direction a = on_sphere(random_point_at(seeded, centre, 3e5));
    const Direction b = on_sphere(random_point_at(seeded, centre, 3e5));
    const Point p = chart.project(a);
    const Point q = chart.project(b);
    const double turn = dot(cross(a, b), chart.centre());
    EXPECT_EQ(turn > 0, p.x * q.y - p.y * q.x > 0);
    const Point middle = chart.project(unit(a + b));
    const double off = (middle.x - p.x) * (q.y - p.y) - (middle.y - p.y) * (q.x - p.x);
    EXPECT_NEAR(off, 0, 2e-16 * 0.1);
  }
}

// Triangles of great circles, against rings in longitude and latitude that follow their sides.
TEST(ChartSurface, has_the_ellipsoid_s_areas) {
  Seeded seeded;
  for (const double reach : {1e3, 3e4, 2e5, 6e5}) {
    for (std::uint64_t i = 0; i < Seeded::rounds(20); ++i) {
      const Point centre{seeded.uniform(-180, 180), seeded.uniform(-60, 60)};
      const GnomonicChart chart(on_sphere(centre));
      const ChartSurface surface(chart);
      std::vector<Point> corners;
      for (int corner = 0; corner < 3; ++corner)
        corners.push_back(chart.project(on_sphere(random_point_at(seeded, centre, reach))));
      double area = 0;
      std::vector<Point> ring;
      constexpr int pieces = 10000;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Point a = corners[corner];
        const Point b = corners[(corner + 1) % 3];
        area -= surface.under(a, b, 0);
        EXPECT_EQ(surface.under(b, a, 0), -surface.under(a, b, 0));
        for (int piece = 0; piece < pieces; ++piece) {
          const double along = static_cast<double>(piece) / pieces;
          Point p =
              from_sphere(chart.direction({a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)}));
          p.x -= 360 * std::round((p.x - centre.x) / 360);
          ring.push_back(p);
        }
      }
      EXPECT_NEAR(area, area_on_ellipsoid(ring), 1e-8 * reach * reach + 1e-6 * reach) << reach;
    }
  }
}

// A square of the chart, 1e-4 across, at the pole and at the equator: its sides are known.
TEST(GnomonicChart, has_a_unit_area_of_the_scale_squared) {
  for (const double latitude : {0.0, 45.0, 90.0}) {
    const GnomonicChart chart(on_sphere({20, latitude}));
    const double scale = scale_on_earth(chart.centre().z);
    EXPECT_NEAR(chart.unit_area({0, 0}) / (scale * scale), 1, 1e-12);
  }
}

}  // namespace
}  // namespace thiessen
