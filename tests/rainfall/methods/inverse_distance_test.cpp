#include "rainfall/methods/inverse_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "earth/sphere/geodesic.h"
#include "rainfall/methods/basin_points.h"
#include "rainfall/methods/method_study.h"

namespace thiessen {
namespace {

using namespace by_method;

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

}  // namespace
}  // namespace thiessen
