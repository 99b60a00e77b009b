#include "map/sheet/projection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "map/sheet/longitude_window.h"
#include "map/sheet/map_shape.h"

namespace thiessen {
namespace {

constexpr double radian = std::numbers::pi / 180;

/// Metres to a degree of latitude and of longitude on WGS 84, from its radii of curvature.
struct DegreeLengths {
  double north;
  double east;
};

DegreeLengths degree_lengths(double latitude) {
  const double a = 6378137;
  const double square = (2 - 1 / 298.257223563) / 298.257223563;
  const double sine = std::sin(latitude * radian);
  const double w = 1 - square * sine * sine;
  return {a * (1 - square) / (w * std::sqrt(w)) * radian,
          a * std::cos(latitude * radian) / std::sqrt(w) * radian};
}

TEST(Projection, stereographic_is_conformal_and_true_at_its_centre) {
  for (const double centre : {-80.0, -33.0, 0.0, 39.0, 60.0, 89.0}) {
    const MapProjection project = MapProjection::stereographic({20, centre});
    for (const double dy : {0.0, 7.0, -15.0, 30.0}) {
      for (const double dx : {0.0, 12.0, -40.0}) {
        const Point p{20 + dx, std::clamp(centre + dy, -88.0, 88.0)};
        const double h = 1e-4;
        const Point north0 = project({p.x, p.y - h});
        const Point north1 = project({p.x, p.y + h});
        const Point east0 = project({p.x - h, p.y});
        const Point east1 = project({p.x + h, p.y});
        const DegreeLengths degree = degree_lengths(p.y);
        const double north = std::hypot(north1.x - north0.x, north1.y - north0.y) / degree.north;
        const double east = std::hypot(east1.x - east0.x, east1.y - east0.y) / degree.east;
        EXPECT_NEAR(north / east, 1, 1e-6);
        const double turn = (north1.x - north0.x) * (east1.x - east0.x) +
                            (north1.y - north0.y) * (east1.y - east0.y);
        EXPECT_NEAR(turn, 0, 1e-6 * h * h);
        if (dx == 0 && p.y == centre) {
          EXPECT_NEAR(north / (2 * h) * project.metres_per_unit(), 1, 1e-6);
          EXPECT_NEAR(north1.x, 0, 1e-12) << "north is up";
        }
      }
    }
  }
}

TEST(Projection, stereographic_at_a_pole_is_round) {
  const MapProjection project = MapProjection::stereographic({0, 90});
  for (int lon = -180; lon < 180; lon += 30) {
    const Point p = project({1.0 * lon, 60});
    const Point q = project({0, 60});
    EXPECT_NEAR(std::hypot(p.x, p.y), std::hypot(q.x, q.y), 1e-12);
  }
}

TEST(Projection, plate_carree_is_true_along_its_latitude) {
  const MapProjection project = MapProjection::plate_carree({}, 60);
  EXPECT_NEAR(project({10, 60}).x - project({0, 60}).x, 10 * radian * 0.5, 1e-15);
  EXPECT_NEAR(project.period(), std::numbers::pi, 1e-15);
}

TEST(LongitudeWindow, goes_the_shorter_way_round) {
  LongitudeCensus census;
  census.add(170);
  census.add(-175);
  const LongitudeWindow window = census.window();
  EXPECT_NEAR(window.west, 170, 1e-9);
  EXPECT_NEAR(window.span, 15, 1e-9);
  EXPECT_NEAR(window.place(-175), 185, 1e-9);
  EXPECT_NEAR(window.place(170), 170, 1e-9);
}

TEST(LongitudeWindow, edges_count_and_not_vertices_alone) {
  LongitudeCensus census;
  census.add(Ring{{-100, 0}, {40, 0}, {40, 10}, {-100, 10}});
  const LongitudeWindow window = census.window();
  EXPECT_NEAR(window.west, -100, 1e-9);
  EXPECT_NEAR(window.span, 140, 1e-9);
}

TEST(LongitudeWindow, an_edge_over_the_antimeridian_goes_the_short_way) {
  LongitudeCensus census;
  census.add(Ring{{170, 0}, {-160, 0}, {-160, 10}, {170, 10}});
  EXPECT_NEAR(census.window().west, 170, 1e-9);
  EXPECT_NEAR(census.window().span, 30, 1e-9);
}

TEST(LongitudeWindow, the_whole_earth_has_no_gap) {
  LongitudeCensus census;
  census.add(Ring{{-180, -90}, {180, -90}, {180, 90}, {-180, 90}});
  EXPECT_EQ(census.window().west, -180);
  EXPECT_EQ(census.window().span, 360);
  LongitudeCensus around;
  Ring ring;
  for (int lon = -180; lon < 180; lon += 15) ring.push_back({1.0 * lon, 70});
  around.add(ring);
  EXPECT_EQ(around.window().span, 360);
}

TEST(LongitudeWindow, one_place_has_no_width) {
  LongitudeCensus census;
  census.add(12.5);
  EXPECT_NEAR(census.window().west, 12.5, 1e-9);
  EXPECT_NEAR(census.window().span, 0, 1e-9);
}

TEST(LongitudeWindow, a_ring_round_the_earth_is_closed_over_its_pole) {
  Ring ring;
  for (int lon = -180; lon < 180; lon += 30) ring.push_back({1.0 * lon, -70});
  const Ring closed = unwrapped(ring, {});
  ASSERT_EQ(closed.size(), ring.size() + 3);
  EXPECT_EQ(closed[12], (Point{180, -70}));
  EXPECT_EQ(closed[13], (Point{180, -90}));
  EXPECT_EQ(closed[14], (Point{-180, -90}));
}

TEST(MapShape, edges_follow_their_curve_alike_in_both_directions) {
  const MapProjection project = MapProjection::stereographic({0, 50});
  const LongitudeWindow window{-30, 60};
  const double tolerance = 1e-4;
  const MultiPolygon forth{{{{-30, 60}, {30, 60}, {0, 40}}, {}}};
  const MultiPolygon back{{{{30, 60}, {-30, 60}, {0, 80}}, {}}};
  const MapShape a = map_shape(forth, project, window, tolerance);
  const MapShape b = map_shape(back, project, window, tolerance);
  const auto along_sixty = [](const MapShape& shape) {
    std::vector<Point> points;
    for (const Point p : shape[0].rings[0]) points.push_back(p);
    std::sort(points.begin(), points.end());
    return points;
  };
  std::vector<Point> shared;
  const auto p = along_sixty(a);
  const auto q = along_sixty(b);
  std::set_intersection(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(shared));
  // The parallel bends by r (1 - cos(angle)): more points than its ends are needed, and all shared.
  EXPECT_GT(shared.size(), 10u);
  for (int lon = -30; lon <= 30; ++lon) {
    const Point exact = project({1.0 * lon, 60});
    double nearest = 1;
    for (std::size_t i = 1; i < shared.size(); ++i) {
      const double t = (exact.x - shared[i - 1].x) / (shared[i].x - shared[i - 1].x);
      if (t < 0 || t > 1) continue;
      const double y = shared[i - 1].y + t * (shared[i].y - shared[i - 1].y);
      nearest = std::min(nearest, std::abs(y - exact.y));
    }
    EXPECT_LT(nearest, 2 * tolerance) << "at longitude " << lon;
  }
}

TEST(MapShape, a_cut_along_the_antimeridian_is_no_outline) {
  const MultiPolygon cut{{{{170, -20}, {180, -20}, {180, -10}, {170, -10}}, {}},
                         {{{-180, -20}, {-170, -20}, {-170, -10}, {-180, -10}}, {}}};
  const MapProjection project = MapProjection::stereographic({180, -15});
  const MapShape shape = map_shape(cut, project, {170, 20}, 1e-3);
  const double middle = project({180, -15}).x;
  for (const MapPart& part : shape) {
    for (const auto& line : part.lines) {
      for (std::size_t i = 1; i < line.size(); ++i) {
        const bool along_cut =
            std::abs(line[i].x - middle) < 1e-9 && std::abs(line[i - 1].x - middle) < 1e-9;
        EXPECT_FALSE(along_cut);
      }
    }
  }
  ASSERT_EQ(shape.size(), 2u);
  const auto by_x = [](Point a, Point b) { return a.x < b.x; };
  const Ring& west = shape[0].rings[0];
  const Ring& east = shape[1].rings[0];
  EXPECT_NEAR(std::max_element(west.begin(), west.end(), by_x)->x, middle, 1e-12);
  EXPECT_NEAR(std::min_element(east.begin(), east.end(), by_x)->x, middle, 1e-12);
}

}  // namespace
}  // namespace thiessen
