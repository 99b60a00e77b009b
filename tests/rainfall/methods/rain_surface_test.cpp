#include "rainfall/methods/rain_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "earth/random_points.h"
#include "earth/sphere/conformal_sphere.h"
#include "earth/tangent_cell.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

using Field = std::function<double(Point)>;

/// Gauges at the corners of a square of 100 and scattered within it, and what a field has there.
struct Scattered {
  explicit Scattered(const Field& field) : network({}, Metric::planar) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0, 100);
    std::vector<Station> stations;
    for (const Point corner : {Point{0, 0}, {100, 0}, {100, 100}, {0, 100}})
      stations.push_back({"", corner});
    for (int i = 0; i < 60; ++i) {
      const double x = uniform(random);
      stations.push_back({"", {x, uniform(random)}});
    }
    for (const Station& station : stations) readings.push_back(field(station.position));
    network = Network(std::move(stations), Metric::planar);
  }

  Network network;
  std::vector<double> readings;
};

double plane(Point p) {
  return 3 + 0.25 * p.x - 0.125 * p.y;
}

TEST(RainSurface, natural_and_linear_reproduce_a_plane_within_the_hull) {
  const Scattered gauges(plane);
  for (const SurfaceMethod method : {SurfaceMethod::natural, SurfaceMethod::linear}) {
    const auto surface = surface_of(method, gauges.network, Metric::planar, gauges.readings);
    for (int x = 0; x <= 100; x += 4) {
      for (int y = 0; y <= 100; y += 5) {
        const Point p{x * 1.0, y * 1.0};
        const RainSurface::Value value = surface->at(p);
        EXPECT_TRUE(value.is_among_gauges) << x << ' ' << y;
        EXPECT_NEAR(value.rainfall, plane(p), 1e-11) << name_of(method) << ' ' << x << ' ' << y;
      }
    }
  }
}

TEST(RainSurface, beyond_the_hull_the_nearest_gauge_counts) {
  const Network network({{"a", {0, 0}}, {"b", {4, 0}}, {"c", {0, 4}}}, Metric::planar);
  const std::vector<double> readings{1, 2, 5};
  for (const SurfaceMethod method : {SurfaceMethod::natural, SurfaceMethod::linear}) {
    const auto surface = surface_of(method, network, Metric::planar, readings);
    const RainSurface::Value beyond = surface->at({9, 1});
    EXPECT_FALSE(beyond.is_among_gauges);
    EXPECT_EQ(beyond.rainfall, 2);
    EXPECT_EQ(surface->at({0, 4}).rainfall, 5);
    EXPECT_TRUE(surface->at({2, 0}).is_among_gauges);
    EXPECT_NEAR(surface->at({2, 0}).rainfall, 1.5, 1e-15);
  }
}

TEST(RainSurface, linear_is_linear_in_each_triangle) {
  // Two triangles; the diagonal runs from (0, 0) to (4, 3), for it is the Delaunay one.
  const Network network({{"a", {0, 0}}, {"b", {5, -1}}, {"c", {4, 3}}, {"d", {-1, 4}}},
                        Metric::planar);
  const auto surface =
      surface_of(SurfaceMethod::linear, network, Metric::planar, std::vector<double>{0, 10, 4, 20});
  EXPECT_NEAR(surface->at({2, 1.5}).rainfall, 2, 1e-14);
  // The middles of both triangles.
  EXPECT_NEAR(surface->at({3, 2.0 / 3}).rainfall, 14.0 / 3, 1e-14);
  EXPECT_NEAR(surface->at({1, 7.0 / 3}).rainfall, 8, 1e-14);
}

TEST(RainSurface, idw_weighs_by_the_square_of_the_distance) {
  const Network network({{"a", {0, 0}}, {"b", {3, 0}}, {"c", {0, 0}}, {"d", {9, 9}}},
                        Metric::planar);
  const auto surface =
      surface_of(SurfaceMethod::idw, network, Metric::planar, std::vector<double>{1, 7, 5, silent});
  EXPECT_EQ(surface->at({0, 0}).rainfall, 3);
  // 1 and 2 away: weights 4 and 1.
  EXPECT_NEAR(surface->at({1, 0}).rainfall, (4 * 3 + 7) / 5.0, 1e-14);
  EXPECT_TRUE(surface->at({100, 0}).is_among_gauges);
}

TEST(RainSurface, of_gauges_on_a_line_is_the_nearest_one_s_off_it) {
  const Network network({{"a", {0, 0}}, {"b", {4, 0}}}, Metric::planar);
  for (const SurfaceMethod method : {SurfaceMethod::natural, SurfaceMethod::linear}) {
    const auto surface = surface_of(method, network, Metric::planar, std::vector<double>{1, 3});
    EXPECT_NEAR(surface->at({1, 0}).rainfall, 1.5, 1e-15);
    EXPECT_EQ(surface->at({1, 1}).rainfall, 1);
    EXPECT_FALSE(surface->at({1, 1}).is_among_gauges);
  }
}

TEST(RainSurface, on_the_earth_equal_readings_are_equal_everywhere_and_gauges_keep_theirs) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Station> stations;
  std::vector<double> readings;
  for (int i = 0; i < 50; ++i) {
    const double x = uniform(random);
    stations.push_back({"", {175 + 10 * x, -45 + 10 * uniform(random)}});
    readings.push_back(i);
  }
  const Network network(std::move(stations), Metric::geodesic);
  for (const SurfaceMethod method :
       {SurfaceMethod::idw, SurfaceMethod::natural, SurfaceMethod::linear}) {
    const auto equal = surface_of(method, network, Metric::geodesic, std::vector<double>(50, 2.5));
    for (double x = 174; x < 186; x += 0.7)
      EXPECT_NEAR(equal->at({x, -40.3}).rainfall, 2.5, 1e-13) << name_of(method);
    const auto surface = surface_of(method, network, Metric::geodesic, readings);
    for (std::size_t i = 0; i < readings.size(); ++i)
      EXPECT_NEAR(surface->at(network.stations()[i].position).rainfall, readings[i], 1e-7);
  }
}

/// Gauges all over the Earth, four of which see to it that no hemisphere is without one.
struct Globe {
  Globe(Seeded& seeded, int count) : network({}, Metric::geodesic) {
    std::vector<Point> places{{0, 90}, {0, -19}, {120, -19}, {-120, -19}};
    while (std::ssize(places) < count) places.push_back(random_point(seeded));
    std::vector<Station> stations;
    for (const Point p : places) {
      stations.push_back({std::to_string(stations.size()), p});
      directions.push_back(on_sphere(stations.back().position));
      readings.push_back(seeded.uniform(0, 100));
    }
    network = Network(std::move(stations), Metric::geodesic);
  }

  Network network;
  std::vector<Direction> directions;
  std::vector<double> readings;
};

double volume(Direction a, Direction b, Direction c) {
  return dot(a, cross(b, c));
}

/// What is linear in the face of the gauges' convex hull, in space, that is seen in the direction
/// x: of all triangles the one that x passes through and that has every gauge on its inner side.
double linear_by_faces(const Globe& globe, Direction x) {
  const auto& g = globe.directions;
  double value = silent;
  for (std::size_t i = 0; i < g.size(); ++i) {
    for (std::size_t j = i + 1; j < g.size(); ++j) {
      for (std::size_t k = j + 1; k < g.size(); ++k) {
        const double turn = volume(g[i], g[j], g[k]) > 0 ? 1 : -1;
        const std::array<double, 3> weights{turn * volume(x, g[j], g[k]),
                                            turn * volume(g[i], x, g[k]),
                                            turn * volume(g[i], g[j], x)};
        if (*std::min_element(weights.begin(), weights.end()) < -1e-12) continue;
        const Direction outward = turn * cross(g[j] - g[i], g[k] - g[i]);
        const bool is_face = std::all_of(g.begin(), g.end(), [&](Direction other) {
          return dot(outward, other - g[i]) < 1e-12;
        });
        if (!is_face) continue;
        value = (weights[0] * globe.readings[i] + weights[1] * globe.readings[j] +
                 weights[2] * globe.readings[k]) /
                (weights[0] + weights[1] + weights[2]);
      }
    }
  }
  return value;
}

/// By the areas that the cell of x takes from those of the gauges, each cut out of the plane that
/// touches the sphere at x; nothing where the cell reaches too far for that plane.
std::optional<double> natural_by_cells(const Globe& globe, Direction x) {
  TangentCell cell(x);
  for (const Direction other : globe.directions) cell.keep_nearer(x, other);
  if (!cell.is_whole()) return {};
  double sum = 0;
  for (std::size_t i = 0; i < globe.directions.size(); ++i) {
    TangentCell part = cell;
    for (std::size_t k = 0; k < globe.directions.size(); ++k) {
      if (k != i) part.keep_nearer(globe.directions[i], globe.directions[k]);
    }
    sum += part.area_on_sphere() * globe.readings[i];
  }
  return sum / cell.area_on_sphere();
}

/// Points everywhere, at the gauge that is the first by coordinates, and very near it.
std::vector<Point> points_on(const Globe& globe, Seeded& seeded) {
  Point first = globe.network.stations().front().position;
  for (const Station& station : globe.network.stations()) first = std::min(first, station.position);
  std::vector<Point> points{first, {first.x, first.y + 1e-6}, {first.x + 1e-3, first.y - 1e-3}};
  for (int i = 0; i < 60; ++i) points.push_back(random_point(seeded));
  return points;
}

TEST(RainSurface, of_a_globe_is_linear_in_each_face_of_the_gauges_hull_in_space) {
  Seeded seeded;
  for (const int count : {16, 40, 60}) {
    const Globe globe(seeded, count);
    const auto surface =
        surface_of(SurfaceMethod::linear, globe.network, Metric::geodesic, globe.readings);
    for (const Point p : points_on(globe, seeded)) {
      const RainSurface::Value value = surface->at(p);
      EXPECT_TRUE(value.is_among_gauges) << p.x << ' ' << p.y;
      EXPECT_NEAR(value.rainfall, linear_by_faces(globe, on_sphere(p)), 1e-6) << p.x << ' ' << p.y;
    }
  }
}

TEST(RainSurface, of_a_globe_has_natural_neighbours_everywhere) {
  Seeded seeded;
  int compared = 0;
  for (const int count : {16, 40, 100}) {
    const Globe globe(seeded, count);
    const auto surface =
        surface_of(SurfaceMethod::natural, globe.network, Metric::geodesic, globe.readings);
    for (const Point p : points_on(globe, seeded)) {
      const RainSurface::Value value = surface->at(p);
      EXPECT_TRUE(value.is_among_gauges) << p.x << ' ' << p.y;
      const std::optional<double> expected = natural_by_cells(globe, on_sphere(p));
      if (!expected) continue;
      EXPECT_NEAR(value.rainfall, *expected, 1e-5) << p.x << ' ' << p.y;
      ++compared;
    }
  }
  EXPECT_GT(compared, 150);
}

// The triangle of three gauges has its edge on x + y = 4; beyond it linear goes on as its plane.
TEST(RainSurface, is_continued_beyond_the_hull_without_a_jump) {
  const Network network({{"a", {0, 0}}, {"b", {4, 0}}, {"c", {0, 4}}}, Metric::planar);
  const std::vector<double> readings{1, 2, 5};
  const auto linear = surface_of(SurfaceMethod::linear, network, Metric::planar, readings);
  const auto natural = surface_of(SurfaceMethod::natural, network, Metric::planar, readings);
  for (const Point p : {Point{2.25, 2.25}, {1, 3.5}, {3, 1.25}, {2, -0.5}, {-0.5, 2}}) {
    const RainSurface::Value value = linear->continued(p);
    EXPECT_FALSE(value.is_among_gauges);
    EXPECT_NEAR(value.rainfall, 1 + p.x / 4 + p.y, 1e-14) << p.x << ' ' << p.y;
  }
  // Natural neighbours of three gauges in a triangle make the same plane.
  EXPECT_NEAR(natural->continued({2.25, 2.25}).rainfall, 1 + 2.25 / 4 + 2.25, 1e-13);
  // Among the gauges it is what it is, and far from them, or beyond a corner, the hull's edge.
  EXPECT_TRUE(linear->continued({1, 1}).is_among_gauges);
  EXPECT_EQ(linear->continued({1, 1}).rainfall, linear->at({1, 1}).rainfall);
  EXPECT_NEAR(linear->continued({102, 102}).rainfall, 3.5, 1e-14);
  EXPECT_EQ(linear->continued({9, -1}).rainfall, 2);
  // Gauges on a line have no hull's edge to go on from.
  const Network line({{"a", {0, 0}}, {"b", {4, 0}}}, Metric::planar);
  EXPECT_EQ(surface_of(SurfaceMethod::linear, line, Metric::planar, std::vector<double>{1, 3})
                ->continued({1, 1})
                .rainfall,
            1);
}

}  // namespace
}  // namespace thiessen
