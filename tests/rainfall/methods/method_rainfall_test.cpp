// What the methods other than the cells' give: by hand, and where gauges are silent by the network
// that never had them.
#include "rainfall/methods/method_rainfall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "basin/shapes.h"
#include "earth/sphere/geodesic.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/methods/arithmetic_mean.h"
#include "rainfall/methods/basin_points.h"
#include "rainfall/methods/inverse_distance.h"
#include "rainfall/methods/natural_neighbours.h"
#include "rainfall/textbook.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();
const Yardstick plane{Metric::planar, 1, 0.1};
const Yardstick earth{Metric::geodesic, 1, 0.1};

struct Study {
  Study(std::vector<Station> stations, std::vector<Basin> areas, const Yardstick& yardstick)
      : network(std::move(stations), yardstick.metric),
        basins(std::move(areas)),
        weighing(network, basins, yardstick) {}

  Network network;
  std::vector<Basin> basins;
  Weighing weighing;
};

using Make = std::function<std::unique_ptr<const AreaMethod>(const Weighing&)>;
const Make arithmetic = [](const Weighing& w) { return std::make_unique<const ArithmeticMean>(w); };
const Make idw = [](const Weighing& w) {
  return std::make_unique<const InverseDistance>(w, 300, 2);
};
const Make natural = [](const Weighing& w) {
  return std::make_unique<const NaturalNeighbours>(w, 300, 2);
};

std::vector<BasinRainfall> rainfall_of(const Study& study, const Make& make,
                                       const std::vector<double>& readings, Gaps gaps,
                                       std::size_t min_gauges = 1) {
  const MethodRainfall rainfall(study.weighing, make(study.weighing), {gaps, min_gauges});
  const auto values = rainfall.at(readings);
  const auto weights = rainfall.weights_at(readings);
  for (std::size_t b = 0; b < values.size(); ++b) {  // the account is that of the value
    double sum = 0;
    for (const StationWeight& s : weights[b].stations) sum += s.weight * readings[index(s.station)];
    if (weights[b].stations.empty()) {
      EXPECT_TRUE(std::isnan(values[b].rainfall));
    } else {
      EXPECT_NEAR(sum, values[b].rainfall, 1e-11 * (1 + std::abs(sum)));
      EXPECT_EQ(weights[b].stations.size(), values[b].gauges);
    }
  }
  return values;
}

Study textbook_study() {
  return {textbook::stations(), {textbook::basin()}, plane};
}

TEST(ArithmeticMean, is_of_the_gauges_inside) {
  const Study study = textbook_study();
  // Gauges 2, 5, 7, 9 and, on the edge, 3.
  auto value = rainfall_of(study, arithmetic, textbook::readings(), Gaps::retessellate)[0];
  EXPECT_DOUBLE_EQ(value.rainfall, (59 + 41 + 105 + 60 + 81) / 5.0);
  EXPECT_EQ(value.gauges, 5u);
  EXPECT_EQ(value.coverage, 1);
  std::vector<double> readings = textbook::readings();
  readings[1] = silent;
  value = rainfall_of(study, arithmetic, readings, Gaps::retessellate)[0];
  EXPECT_DOUBLE_EQ(value.rainfall, (41 + 105 + 60 + 81) / 4.0);
  EXPECT_DOUBLE_EQ(value.coverage, 0.8);
  EXPECT_DOUBLE_EQ(rainfall_of(study, arithmetic, readings, Gaps::renormalise)[0].rainfall,
                   (41 + 105 + 60 + 81) / 4.0);
  EXPECT_TRUE(std::isnan(rainfall_of(study, arithmetic, readings, Gaps::strict)[0].rainfall));
  EXPECT_TRUE(
      std::isnan(rainfall_of(study, arithmetic, readings, Gaps::retessellate, 5)[0].rainfall));
  for (const std::size_t i : {2u, 4u, 6u, 8u}) readings[i] = silent;
  value = rainfall_of(study, arithmetic, readings, Gaps::retessellate)[0];
  EXPECT_TRUE(std::isnan(value.rainfall));
  EXPECT_EQ(value.gauges, 0u);
}

TEST(ArithmeticMean, over_the_antimeridian_and_at_shared_places) {
  const Basin basin = shapes::basin({{shapes::rectangle({175, -5}, {185, 5}), {}}});
  const Study study({{"a", {179, 0}}, {"b", {-179, 1}}, {"c", {-179, 1}}, {"d", {170, 0}}}, {basin},
                    earth);
  EXPECT_DOUBLE_EQ(rainfall_of(study, arithmetic, {1, 3, 5, 100}, Gaps::retessellate)[0].rainfall,
                   2.5);
  const auto value = rainfall_of(study, arithmetic, {1, silent, 5, 100}, Gaps::retessellate)[0];
  EXPECT_DOUBLE_EQ(value.rainfall, 3);
  EXPECT_EQ(value.gauges, 2u);
  EXPECT_DOUBLE_EQ(value.coverage, 0.75);
  EXPECT_DOUBLE_EQ(
      rainfall_of(study, arithmetic, {1, silent, 5, 100}, Gaps::renormalise)[0].rainfall,
      (0.5 * 1 + 0.25 * 5) / 0.75);
}

/// Inverse distance at one point, as it is written in textbooks.
double idw_at(Point p, const std::vector<Station>& stations, const std::vector<double>& readings,
              Metric metric) {
  std::vector<std::pair<double, double>> near;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const Point q = stations[i].position;
    if (std::isnan(readings[i])) continue;
    near.emplace_back(
        metric == Metric::planar ? std::hypot(p.x - q.x, p.y - q.y) : geodesic_distance(p, q),
        readings[i]);
  }
  std::sort(near.begin(), near.end());
  near.resize(std::min<std::size_t>(12, near.size()));
  double sum = 0;
  double weights = 0;
  for (const auto& [distance, reading] : near) {
    if (distance == 0) return reading;
    sum += reading / (distance * distance);
    weights += 1 / (distance * distance);
  }
  return sum / weights;
}

std::vector<Station> scattered(Seeded& seeded, std::size_t count, Point middle, double size) {
  std::vector<Station> stations;
  for (std::size_t i = 0; i < count; ++i) {
    stations.push_back(
        {std::to_string(i),
         {middle.x + seeded.uniform(-size, size), middle.y + seeded.uniform(-size, size)}});
  }
  return stations;
}

TEST(InverseDistance, is_the_mean_over_the_points_whatever_is_silent) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(20); ++round) {
    const Yardstick& yardstick = round % 2 == 0 ? plane : earth;
    const Point middle{seeded.uniform(-170, 170), seeded.uniform(-60, 60)};
    const auto stations = scattered(seeded, 1 + seeded.below(60), middle, 3);
    const Basin basin = shapes::basin({{shapes::star(seeded, middle, 2, 12), {}}});
    const Study study(stations, {basin}, yardstick);
    const double share = seeded.uniform(0, 1);
    std::vector<double> readings;
    for (std::size_t i = 0; i < stations.size(); ++i)
      readings.push_back(i > 0 && seeded.uniform(0, 1) < share ? silent : seeded.uniform(0, 100));
    double mean = 0;
    for (const Point p : basin_points(basin, yardstick, 300))
      mean += idw_at(p, stations, readings, yardstick.metric) / 300;
    EXPECT_NEAR(rainfall_of(study, idw, readings, Gaps::retessellate)[0].rainfall, mean, 1e-5);
  }
}

TEST(InverseDistance, a_gauge_at_a_point_has_all_of_it) {
  // The four points of a square, one with a gauge.
  const Basin square = shapes::basin({{shapes::rectangle({0, 0}, {2, 2}), {}}});
  const Study study({{"a", {0.5, 0.5}}, {"b", {5, 0.5}}}, {square}, plane);
  const Make four = [](const Weighing& w) {
    return std::make_unique<const InverseDistance>(w, 4, 1);
  };
  double expected = 10;
  for (const Point p : {Point{1.5, 0.5}, Point{1.5, 1.5}, Point{0.5, 1.5}})
    expected += idw_at(p, study.network.stations(), {10, 30}, Metric::planar);
  EXPECT_NEAR(rainfall_of(study, four, {10, 30}, Gaps::retessellate)[0].rainfall, expected / 4,
              1e-6);
  EXPECT_EQ(rainfall_of(study, four, {silent, 30}, Gaps::retessellate)[0].rainfall, 30);
  EXPECT_TRUE(
      std::isnan(rainfall_of(study, four, {silent, silent}, Gaps::retessellate)[0].rainfall));
}

// A field that is linear comes back, inside the hull.
TEST(NaturalNeighbours, give_a_plane_its_mean) {
  Seeded seeded;
  std::vector<Station> stations = scattered(seeded, 50, {0, 0}, 5);
  for (const Point corner : {Point{-9, -9}, Point{9, -9}, Point{9, 9}, Point{-9, 9}})
    stations.push_back({"corner", corner});
  const Basin basin = shapes::basin({{shapes::star(seeded, {0, 0}, 4, 12), {}}});
  const Study study(stations, {basin}, plane);
  std::vector<double> readings;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const bool reports = i >= 50 || seeded.below(3) > 0;
    readings.push_back(reports ? 100 + 3 * stations[i].position.x - 2 * stations[i].position.y
                               : silent);
  }
  double mean = 0;
  for (const Point p : basin_points(basin, plane, 300)) mean += (100 + 3 * p.x - 2 * p.y) / 300;
  EXPECT_NEAR(rainfall_of(study, natural, readings, Gaps::retessellate)[0].rainfall, mean, 1e-11);
}

TEST(NaturalNeighbours, silent_gauges_are_as_if_they_had_never_been) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(30); ++round) {
    const Yardstick& yardstick = round % 2 == 0 ? plane : earth;
    const Point middle{seeded.uniform(-170, 170), seeded.uniform(-60, 60)};
    const auto stations = scattered(seeded, 4 + seeded.below(40), middle, 3);
    std::vector<Basin> basins;
    for (int i = 0; i < 3; ++i) {
      const Point centre{middle.x + seeded.uniform(-2, 2), middle.y + seeded.uniform(-2, 2)};
      basins.push_back(shapes::basin({{shapes::star(seeded, centre, 1, 12), {}}}));
    }
    const Study study(stations, basins, yardstick);
    const double share = seeded.uniform(0, 1);
    std::vector<double> readings;
    std::vector<Station> rest;
    std::vector<double> rest_readings;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const bool reports = i == 0 || seeded.uniform(0, 1) > share;
      readings.push_back(reports ? seeded.uniform(0, 100) : silent);
      if (!reports) continue;
      rest.push_back(stations[i]);
      rest_readings.push_back(readings.back());
    }
    const Study others(rest, basins, yardstick);
    const auto values = rainfall_of(study, natural, readings, Gaps::retessellate);
    const auto expected = rainfall_of(others, natural, rest_readings, Gaps::retessellate);
    // On the Earth the hull of the others is seen from the middle of another gap.
    const double accuracy = yardstick.metric == Metric::planar ? 1e-9 : 2;
    for (std::size_t b = 0; b < basins.size(); ++b)
      EXPECT_NEAR(values[b].rainfall, expected[b].rainfall, accuracy);
  }
}

TEST(NaturalNeighbours, outside_the_hull_the_nearest) {
  const Basin square = shapes::basin({{shapes::rectangle({0, 0}, {4, 4}), {}}});
  const Study study({{"a", {0, 0}}, {"b", {0, 4}}, {"c", {-5, 2}}}, {square}, plane);
  const NaturalNeighbours method(study.weighing, 400, 1);
  EXPECT_EQ(method.shares_outside(), std::vector<double>{1});
  EXPECT_NEAR(rainfall_of(study, natural, {10, 20, 100}, Gaps::retessellate)[0].rainfall, 15, 0.5);
  const Study half({{"a", {0, -5}}, {"b", {0, 9}}, {"c", {-5, 2}}, {"d", {2, -5}}, {"e", {2, 9}}},
                   {square}, plane);
  EXPECT_NEAR(NaturalNeighbours(half.weighing, 400, 1).shares_outside()[0], 0.5, 1e-9);
}

TEST(NaturalNeighbours, one_gauge_two_and_a_line) {
  const Basin square = shapes::basin({{shapes::rectangle({0, 0}, {4, 4}), {}}});
  for (const Yardstick& yardstick : {plane, earth}) {
    const Study one({{"a", {1, 1}}}, {square}, yardstick);
    EXPECT_EQ(rainfall_of(one, natural, {7}, Gaps::retessellate)[0].rainfall, 7);
    const Study two({{"a", {1, 2}}, {"b", {3, 2}}}, {square}, yardstick);
    EXPECT_NEAR(rainfall_of(two, natural, {0, 10}, Gaps::retessellate)[0].rainfall, 5, 1e-9);
    const Study line({{"a", {1, 2}}, {"b", {2, 2}}, {"c", {3, 2}}}, {square}, yardstick);
    EXPECT_NEAR(rainfall_of(line, natural, {0, 10, 20}, Gaps::retessellate)[0].rainfall, 10, 0.1);
  }
}

// Of Colorado's size, a continent and the world: a constant is a constant, weights add up to 1, and
// a world with gauges all round has no outside but at its largest gap.
TEST(NaturalNeighbours, of_the_world) {
  Seeded seeded;
  std::vector<Station> stations;
  for (int i = 0; i < 500; ++i) {
    stations.push_back(
        {std::to_string(i),
         {seeded.uniform(-180, 180), std::asin(seeded.uniform(-1, 1)) * 180 / M_PI}});
  }
  const Basin world = shapes::basin({{shapes::rectangle({-180, -90}, {180, 90}), {}}});
  const Study study(stations, {world}, earth);
  const NaturalNeighbours method(study.weighing, 3000, 2);
  EXPECT_LT(method.shares_outside()[0], 0.05);
  ReportingPlaces reports(500, true);
  for (std::uint32_t i = 0; i < 500; i += 3) reports.set(PlaceIndex{i}, false);
  for (const auto& weights :
       {method.weights(ReportingPlaces(500, true))[0], method.weights(reports)[0]}) {
    double sum = 0;
    double height = 0;  // of a field that is linear in space
    for (const PlaceWeight& w : weights) {
      sum += w.weight;
      height += w.weight * on_sphere(stations[index(w.place)].position).z;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(height, 0, 0.02);
  }
}

TEST(SeveralMethods, come_basin_by_basin) {
  const Study study = textbook_study();
  std::vector<std::unique_ptr<const StepRainfall>> methods;
  methods.push_back(std::make_unique<const MethodRainfall>(
      study.weighing, arithmetic(study.weighing), ArealRainfallSettings{}));
  methods.push_back(
      std::make_unique<const ArealRainfall>(study.weighing, ArealRainfallSettings{}, 1));
  const SeveralMethods several(std::move(methods));
  const auto values = several.at(textbook::readings());
  ASSERT_EQ(values.size(), 2u);
  EXPECT_NEAR(values[0].rainfall, 69.2, 1e-12);
  EXPECT_NEAR(values[1].rainfall, 69.836427036902, 1e-12);
}

}  // namespace
}  // namespace thiessen
