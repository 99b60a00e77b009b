#include "rainfall/methods/rain_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

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

}  // namespace
}  // namespace thiessen
