#include "map/raster/step_pixels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "map/raster/owners.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

std::vector<MultiPolygon> rectangle(Point a, Point b) {
  return {{{{a, {b.x, a.y}, b, {a.x, b.y}}, {}}}};
}

void to_degrees(std::vector<Point>& points) {
  for (Point& p : points) p = {p.x / 70e3 - p.y * p.x / 70e10, p.y / 111e3};
}

struct Case {
  PixelGrid grid;
  std::vector<MultiPolygon> areas;
  Network network;
  Metric metric = Metric::planar;
  PointMapping to_study = [](std::vector<Point>&) {};
};

Network random_network(std::mt19937_64& random, std::size_t count, Point low, Point high,
                       Metric metric) {
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Station> stations;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = uniform(random);
    stations.push_back(
        {"", {low.x + x * (high.x - low.x), low.y + uniform(random) * (high.y - low.y)}});
  }
  return {std::move(stations), metric};
}

/// The values of a step from owners that are found for its own gauges alone.
std::vector<float> anew(const Case& c, std::span<const double> readings) {
  const ReportingStations reports = reporting_stations(readings);
  Owners owners(
      c.grid, c.areas, c.network, c.metric, reports, [&] { return c.to_study; }, 1);
  std::vector<float> values;
  for (const std::int32_t owner : owners.rows(0, c.grid.rows)) {
    values.push_back(owner == 0
                         ? std::numeric_limits<float>::quiet_NaN()
                         : static_cast<float>(readings[static_cast<std::size_t>(owner - 1)]));
  }
  return values;
}

/// Compares steps of ever more silent gauges with what is found anew; every reading is another.
void expect_alike(const Case& c, std::mt19937_64& random, unsigned threads) {
  const std::size_t count = c.network.stations().size();
  StepPixels pixels(
      c.grid, c.areas, c.network, c.metric, ReportingStations(count, true),
      [&] { return c.to_study; }, threads);
  for (const double share : {0.0, 0.02, 0.05, 0.05, 0.2, 0.3, 0.6, 0.97, 1.0, 0.05}) {
    std::vector<double> readings;
    std::bernoulli_distribution is_silent(share);
    for (std::size_t s = 0; s < count; ++s)
      readings.push_back(is_silent(random) ? silent : static_cast<double>(s));
    const std::vector<float> wanted = anew(c, readings);
    const std::span<const float> found = pixels.at(readings);
    ASSERT_EQ(found.size(), wanted.size());
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const bool alike = std::isnan(wanted[i]) ? std::isnan(found[i]) : found[i] == wanted[i];
      wrong += alike ? 0 : 1;
    }
    EXPECT_EQ(wrong, 0U) << "share " << share;
  }
}

TEST(StepPixels, are_those_of_the_gauges_that_report_in_a_plane) {
  std::mt19937_64 random(1);
  const Network network = random_network(random, 300, {-20, -20}, {320, 220}, Metric::planar);
  expect_alike({{{0, 200}, 1, 300, 200}, rectangle({10.2, 5}, {290, 180.7}), network}, random, 1);
  expect_alike({{{0, 200}, 1, 300, 200}, rectangle({10.2, 5}, {290, 180.7}), network}, random, 3);
}

TEST(StepPixels, are_so_on_lattices_where_pixels_are_as_near_to_four_gauges) {
  std::mt19937_64 random(2);
  std::vector<Station> stations;
  for (int i = 0; i < 400; ++i) stations.push_back({"", {i % 20 * 8.0, i / 20 * 8.0}});
  std::shuffle(stations.begin(), stations.end(), random);
  const Network network(std::move(stations), Metric::planar);
  for (const double west : {0.0, 0.5}) {
    expect_alike({{{west, 152.5 - west}, 1, 150, 150}, rectangle({-1, -1}, {200, 200}), network},
                 random, 2);
  }
}

TEST(StepPixels, are_so_round_a_circle_of_gauges_whose_middle_is_a_pixel) {
  std::mt19937_64 random(3);
  std::vector<Station> stations;
  for (const Point p : {Point{25, 0}, {24, 7}, {20, 15}, {15, 20}, {7, 24}, {0, 25}}) {
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        if ((p.x == 0 && x < 0) || (p.y == 0 && y < 0)) continue;
        stations.push_back({"", {x * p.x, y * p.y}});
      }
    }
  }
  const Network network(std::move(stations), Metric::planar);
  for (int round = 0; round < 20; ++round) {
    expect_alike({{{-30.5, 30.5}, 1, 61, 61}, rectangle({-40, -40}, {40, 40}), network}, random, 1);
  }
}

TEST(StepPixels, are_so_on_the_earth_in_degrees_and_in_a_projection) {
  std::mt19937_64 random(4);
  expect_alike({{{5, 60}, 0.02, 300, 200},
                rectangle({5, 56}, {11, 60}),
                random_network(random, 200, {4, 55}, {12, 61}, Metric::geodesic),
                Metric::geodesic},
               random, 2);
  expect_alike({{{0, 200e3}, 1e3, 300, 200},
                rectangle({0, 0}, {300e3, 200e3}),
                random_network(random, 150, {0, 0}, {4.3, 1.8}, Metric::geodesic),
                Metric::geodesic,
                to_degrees},
               random, 2);
}

TEST(StepPixels, are_so_for_the_whole_earth) {
  std::mt19937_64 random(5);
  expect_alike({{{-180, 90}, 1.5, 240, 120},
                rectangle({-180, -90}, {180, 90}),
                random_network(random, 60, {-180, -88}, {180, 88}, Metric::geodesic),
                Metric::geodesic},
               random, 1);
}

TEST(StepPixels, a_place_has_the_mean_of_its_gauges_that_report) {
  const Network network({{"a", {0, 0}}, {"b", {0, 0}}, {"c", {10, 0}}}, Metric::planar);
  StepPixels pixels(
      {{-0.5, 0.5}, 1, 11, 1}, rectangle({-1, -1}, {11, 1}), network, Metric::planar,
      ReportingStations(3, true), [] { return [](std::vector<Point>&) {}; }, 1);
  const auto at = [&](std::vector<double> readings, std::size_t pixel) {
    return pixels.at(readings)[pixel];
  };
  EXPECT_EQ(at({1, 4, 7}, 4), 2.5F);
  EXPECT_EQ(at({silent, 4, 7}, 4), 4.0F);
  EXPECT_EQ(at({silent, silent, 7}, 4), 7.0F);
  EXPECT_EQ(at({1, 3, silent}, 10), 2.0F);
  EXPECT_TRUE(std::isnan(at({silent, silent, silent}, 4)));
}

}  // namespace
}  // namespace thiessen
