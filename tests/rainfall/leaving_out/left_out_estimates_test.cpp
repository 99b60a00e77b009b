#include "rainfall/leaving_out/left_out_estimates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "basin/shapes.h"
#include "geometry/seeded.h"
#include "rainfall/methods/rain_surface.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

Basin rectangle_basin(const std::string& id, Point low, Point high) {
  return {id, {{shapes::rectangle(low, high), {}}}, {}};
}

std::vector<Station> stations_at(const std::vector<Point>& places) {
  std::vector<Station> stations;
  for (std::size_t i = 0; i < places.size(); ++i)
    stations.push_back({std::to_string(i), places[i]});
  return stations;
}

ReportingPlaces reporting(const std::vector<double>& values) {
  ReportingPlaces reports(values.size(), false);
  for (std::uint32_t p = 0; p < values.size(); ++p)
    reports.set(PlaceIndex{p}, !std::isnan(values[p]));
  return reports;
}

std::vector<double> told_by(LeftOutEstimates& estimates, PointMethod method,
                            const std::vector<double>& values) {
  std::vector<double> told(values.size(), silent);
  estimates.report(reporting(values));
  estimates.tell(method, values, told);
  return told;
}

/// What a place is told to have by a network from which it is really gone, and whether it lies in
/// the hull of the others.
RainSurface::Value brute_force(SurfaceMethod method, std::vector<Point> places,
                               std::vector<double> values, std::size_t place, Metric metric) {
  const Point at = places[place];
  places.erase(places.begin() + static_cast<std::ptrdiff_t>(place));
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(place));
  const Network network(stations_at(places), metric);
  return surface_of(method, network, metric, values)->at(at);
}

struct Compared {
  std::size_t places = 0;
  std::size_t beyond = 0;  // the hull of the others
  std::size_t unlike = 0;
};

Compared compare(const std::vector<Point>& places, const std::vector<std::vector<double>>& steps,
                 Metric metric) {
  const Network network(stations_at(places), metric);
  LeftOutEstimates estimates(network, metric, {});
  Compared compared;
  for (const auto& values : steps) {
    const auto others = std::count_if(values.begin(), values.end(),
                                      [](double value) { return !std::isnan(value); }) -
                        1;
    for (const auto& [method, surface] : {std::pair(PointMethod::idw, SurfaceMethod::idw),
                                          std::pair(PointMethod::natural, SurfaceMethod::natural),
                                          std::pair(PointMethod::linear, SurfaceMethod::linear)}) {
      const std::vector<double> told = told_by(estimates, method, values);
      for (std::size_t p = 0; p < places.size() && others > 0; ++p) {
        if (std::isnan(values[p])) continue;
        const auto expected = brute_force(surface, places, values, p, metric);
        ++compared.places;
        if (!expected.is_among_gauges) ++compared.beyond;
        if (!(std::abs(told[p] - expected.rainfall) <= 1e-9)) ++compared.unlike;
      }
    }
  }
  return compared;
}

std::vector<std::vector<double>> random_steps(Seeded& seeded, std::size_t places, int count) {
  std::vector<std::vector<double>> steps;
  for (int t = 0; t < count; ++t) {
    const double share = t == 0 ? 0 : seeded.uniform(0, 0.9);
    steps.emplace_back();
    for (std::size_t p = 0; p < places; ++p)
      steps.back().push_back(seeded.uniform(0, 1) < share ? silent : seeded.uniform(0, 50));
  }
  return steps;
}

TEST(LeftOutEstimates, are_those_of_a_network_without_the_gauge_in_the_plane) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(10); ++round) {
    std::vector<Point> places;
    for (int i = 0; i < 45; ++i) places.push_back({seeded.uniform(0, 9), seeded.uniform(0, 9)});
    const Compared compared =
        compare(places, random_steps(seeded, places.size(), 8), Metric::planar);
    EXPECT_EQ(compared.unlike, 0u);
    EXPECT_GT(compared.places, 200u);
    EXPECT_GT(compared.beyond, 0u);
  }
}

// A grid has four gauges on each circle, so which triangles there are is a matter of ties.
TEST(LeftOutEstimates, are_those_of_a_network_without_the_gauge_on_a_grid) {
  Seeded seeded;
  std::vector<Point> places;
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) places.push_back({x * 1.0, y * 1.0});
  }
  std::shuffle(places.begin(), places.end(), seeded.generator());
  EXPECT_EQ(compare(places, random_steps(seeded, places.size(), 12), Metric::planar).unlike, 0u);
}

// The hull on the Earth is seen from the middle of the largest gap between gauges, which is another
// where some are silent: a gauge next to the hull may lie within the one and beyond the other.
TEST(LeftOutEstimates, are_those_of_a_network_without_the_gauge_on_the_earth) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(6); ++round) {
    std::vector<Point> places;
    for (int i = 0; i < 45; ++i)
      places.push_back({seeded.uniform(-109, -102), seeded.uniform(37, 41)});
    const Compared compared =
        compare(places, random_steps(seeded, places.size(), 6), Metric::geodesic);
    EXPECT_LE(compared.unlike, 1u + compared.places / 200);
    EXPECT_GT(compared.beyond, 0u);
  }
}

TEST(LeftOutEstimates, are_those_of_a_network_without_the_gauge_all_round_the_earth) {
  Seeded seeded;
  std::vector<Point> places;
  for (int i = 0; i < 60; ++i) {
    places.push_back({seeded.uniform(-180, 180), std::asin(seeded.uniform(-1, 1)) * 57.29577951});
  }
  const Compared compared =
      compare(places, {random_steps(seeded, 60, 1).front(), random_steps(seeded, 60, 1).front()},
              Metric::geodesic);
  EXPECT_EQ(compared.unlike, 0u);
  EXPECT_EQ(compared.beyond, 0u);
}

TEST(LeftOutEstimates, of_gauges_on_a_line) {
  const std::vector<Point> places{{0, 0}, {1, 0}, {3, 0}, {7, 0}};
  EXPECT_EQ(
      compare(places, {{1, 5, 2, 8}, {1, silent, 2, 8}, {1, silent, silent, 8}}, Metric::planar)
          .unlike,
      0u);
}

TEST(LeftOutEstimates, of_the_only_gauge_that_reports_are_none) {
  const Network network(stations_at({{0, 0}, {1, 0}, {0, 1}}), Metric::planar);
  LeftOutEstimates estimates(network, Metric::planar, {});
  for (const PointMethod method : point_methods)
    EXPECT_TRUE(std::isnan(told_by(estimates, method, {silent, 3, silent})[1])) << name_of(method);
}

// By hand: the corners of a square and its middle. A corner lies beyond the hull of the others,
// whose nearest is the middle; on its side are two gauges, at 1 / 1, across one at 1 / 2, and the
// middle at 2.
TEST(LeftOutEstimates, of_a_square_by_hand) {
  const Network network(stations_at({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}}), Metric::planar);
  LeftOutEstimates estimates(network, Metric::planar, {});
  const std::vector<double> values{10, 20, 30, 40, 50};
  EXPECT_EQ(told_by(estimates, PointMethod::thiessen, values),
            (std::vector<double>{50, 50, 50, 50, 10}));
  EXPECT_EQ(told_by(estimates, PointMethod::arithmetic, values),
            (std::vector<double>{35, 32.5, 30, 27.5, 25}));
  const std::vector<double> idw = told_by(estimates, PointMethod::idw, values);
  EXPECT_NEAR(idw[0], 175 / 4.5, 1e-12);
  EXPECT_NEAR(idw[2], 165 / 4.5, 1e-12);
  EXPECT_NEAR(idw[4], 25, 1e-12);
  const std::vector<double> natural = told_by(estimates, PointMethod::natural, values);
  EXPECT_EQ(natural[0], 50);
  EXPECT_NEAR(natural[4], 25, 1e-12);
  // Of the diagonals it is the one away from the last corner by coordinates.
  EXPECT_NEAR(told_by(estimates, PointMethod::linear, values)[4], 30, 1e-12);
}

// The mean of the others in the first basin that holds a gauge; of all others for the one that has
// its basin for itself, and for the one outside.
TEST(LeftOutEstimates, means_are_of_a_basin) {
  const Network network(stations_at({{1, 1}, {2, 1}, {3, 1}, {12, 1}, {30, 1}}), Metric::planar);
  const std::vector<Basin> basins{rectangle_basin("a", {0, 0}, {10, 10}),
                                  rectangle_basin("b", {10, 0}, {20, 10})};
  LeftOutEstimates estimates(network, Metric::planar, basins);
  EXPECT_EQ(told_by(estimates, PointMethod::arithmetic, {1, 3, 8, 20, 100}),
            (std::vector<double>{5.5, 4.5, 2, 28, 8}));
  EXPECT_EQ(told_by(estimates, PointMethod::arithmetic, {1, silent, silent, 20, 100})[0], 60);
}

// The nearest 40 of each gauge are kept; where these are silent others are looked for.
TEST(LeftOutEstimates, where_most_are_silent) {
  Seeded seeded;
  std::vector<Point> places;
  for (int i = 0; i < 300; ++i) places.push_back({seeded.uniform(0, 9), seeded.uniform(0, 9)});
  std::vector<double> values(300, silent);
  for (std::size_t i = 0; i < 300; i += 60) values[i] = seeded.uniform(0, 50);
  EXPECT_EQ(compare(places, {values}, Metric::planar).unlike, 0u);
}

}  // namespace
}  // namespace thiessen
