// Natural neighbours over the points of a basin: by hand, and where gauges are silent by the
// network that never had them.
#include "rainfall/methods/natural_neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "earth/sphere/conformal_sphere.h"
#include "rainfall/methods/basin_points.h"
#include "rainfall/methods/method_study.h"

namespace thiessen {
namespace {

using namespace by_method;

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

// Neither what is remembered nor what was asked for before changes a bit.
TEST(NaturalNeighbours, weights_depend_on_who_reports_alone) {
  Seeded seeded;
  for (const Yardstick& yardstick : {plane, earth}) {
    const auto stations = scattered(seeded, 60, {5, 45}, 3);
    const Basin basin = shapes::basin({{shapes::star(seeded, {5, 45}, 2, 12), {}}});
    const Study study(stations, {basin}, yardstick);
    const NaturalNeighbours forgetful(study.weighing, 300, 1, 0);
    const NaturalNeighbours natural(study.weighing, 300, 1);
    for (int step = 0; step < 40; ++step) {
      ReportingPlaces reports(60, true);
      for (std::uint32_t p = 0; p < 60; ++p) reports.set(PlaceIndex{p}, seeded.below(8) > 0);
      const auto weights = natural.weights(reports);
      EXPECT_EQ(weights, forgetful.weights(reports));
      EXPECT_EQ(weights, natural.weights(reports));
      EXPECT_EQ(weights, NaturalNeighbours(study.weighing, 300, 1).weights(reports));
    }
  }
}

// A gauge that is the first by coordinates stands at infinity in the chart of the world; where so
// many are silent that the others leave a hemisphere free, these have a hull again.
TEST(NaturalNeighbours, of_the_world_silent_gauges_are_as_if_they_had_never_been) {
  Seeded seeded;
  const Basin world = shapes::basin({{shapes::rectangle({-180, -90}, {180, 90}), {}}});
  std::vector<Station> stations;
  for (int i = 0; i < 60; ++i) {
    stations.push_back(
        {std::to_string(i),
         {seeded.uniform(-180, 180), std::asin(seeded.uniform(-1, 1)) * 180 / M_PI}});
  }
  const std::size_t first = static_cast<std::size_t>(
      std::min_element(stations.begin(), stations.end(),
                       [](const Station& a, const Station& b) { return a.position < b.position; }) -
      stations.begin());
  const Study study(stations, {world}, earth);
  using IsSilent = std::function<bool(std::size_t)>;
  for (const IsSilent& is_silent :
       {IsSilent([&](std::size_t i) { return i == first; }),
        IsSilent([&](std::size_t i) { return i == (first + 1) % 60; }),
        IsSilent([](std::size_t i) { return i % 3 == 1; }),
        IsSilent([&](std::size_t i) { return i != first && stations[i].position.x > -20; }),
        IsSilent([&](std::size_t i) { return i == first || i > 3; })}) {
    std::vector<double> readings;
    std::vector<Station> rest;
    std::vector<double> rest_readings;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      readings.push_back(is_silent(i) ? silent : seeded.uniform(0, 100));
      if (is_silent(i)) continue;
      rest.push_back(stations[i]);
      rest_readings.push_back(readings.back());
    }
    const Study others(rest, {world}, earth);
    EXPECT_NEAR(rainfall_of(study, natural, readings, Gaps::retessellate)[0].rainfall,
                rainfall_of(others, natural, rest_readings, Gaps::retessellate)[0].rainfall, 1e-9);
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
// a world with gauges all round has no outside.
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
  EXPECT_EQ(method.shares_outside()[0], 0);
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

}  // namespace
}  // namespace thiessen
