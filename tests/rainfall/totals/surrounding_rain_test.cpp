#include "rainfall/totals/surrounding_rain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "earth/sphere/geodesic.h"
#include "rainfall/methods/method_study.h"
#include "rainfall/normals/uniform_normals.h"

namespace thiessen {
namespace {

using namespace by_method;

by_method::Study study_of(std::vector<Station> stations, const Yardstick& yardstick = plane) {
  return {
      std::move(stations), {shapes::basin({{shapes::rectangle({0, 0}, {1, 1}), {}}})}, yardstick};
}

double around(const by_method::Study& study, std::size_t gauge,
              const std::vector<double>& readings) {
  SurroundingRain rain(study.weighing);
  const auto by_place = rain.by_place(readings, {});
  return rain.at(StationIndex{static_cast<std::uint32_t>(gauge)}, by_place, {});
}

/// The mean of the 8 nearest that report as textbooks write it.
double mean_of_nearest(const std::vector<Station>& stations, std::size_t gauge,
                       const std::vector<double>& readings, Metric metric) {
  std::vector<std::pair<double, double>> near;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (std::isnan(readings[i])) continue;
    const Point p = stations[gauge].position;
    const Point q = stations[i].position;
    near.emplace_back(
        metric == Metric::planar ? std::hypot(p.x - q.x, p.y - q.y) : geodesic_distance(p, q),
        readings[i]);
  }
  std::sort(near.begin(), near.end());
  near.resize(std::min<std::size_t>(8, near.size()));
  double sum = 0;
  double weights = 0;
  for (const auto& [distance, reading] : near) {
    sum += reading / (distance * distance);
    weights += 1 / (distance * distance);
  }
  return near.empty() ? silent : sum / weights;
}

TEST(SurroundingRain, is_weighed_by_inverse_squares) {
  const auto study = study_of({{"a", {0, 0}, 0}, {"b", {10, 0}, 0}, {"c", {3, 0}, 0}});
  EXPECT_DOUBLE_EQ(around(study, 2, {1, 5, silent}), (1.0 / 9 + 5.0 / 49) / (1.0 / 9 + 1.0 / 49));
  EXPECT_EQ(around(study, 2, {silent, 5, silent}), 5);
  EXPECT_TRUE(std::isnan(around(study, 2, {silent, silent, silent})));
}

TEST(SurroundingRain, is_that_of_the_place_itself_where_a_gauge_reports_there) {
  const auto study =
      study_of({{"a", {0, 0}, 0}, {"b", {3, 0}, 0}, {"c", {3, 0}, 0}, {"d", {3, 0}, 0}});
  EXPECT_EQ(around(study, 2, {1, 5, silent, 7}), 6) << "the mean of the gauges at one place";
  EXPECT_EQ(around(study, 2, {1, silent, silent, silent}), 1);
}

TEST(SurroundingRain, is_of_the_eight_nearest_that_report_whatever_reported_before) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(20); ++round) {
    const Yardstick& yardstick = round % 2 == 0 ? plane : earth;
    const Point middle{seeded.uniform(-170, 170), seeded.uniform(-60, 60)};
    const auto stations = scattered(seeded, 2 + seeded.below(100), middle, 3);
    const auto study = study_of(stations, yardstick);
    SurroundingRain rain(study.weighing);
    for (int step = 0; step < 5; ++step) {
      const double share = seeded.uniform(0, 1.1);
      std::vector<double> readings;
      for (std::size_t i = 0; i < stations.size(); ++i)
        readings.push_back(i == 0 || seeded.uniform(0, 1) < share ? silent
                                                                  : seeded.uniform(0, 100));
      const auto by_place = rain.by_place(readings, {});
      const double found = rain.at(StationIndex{0}, by_place, {});
      const double expected = mean_of_nearest(stations, 0, readings, yardstick.metric);
      EXPECT_EQ(std::isnan(found), std::isnan(expected));
      if (std::isnan(expected)) continue;
      EXPECT_NEAR(found, expected, 1e-7 * expected);
    }
  }
}

TEST(SurroundingRain, is_of_readings_relative_to_their_normals) {
  auto study = study_of({{"a", {0, 0}, 0}, {"b", {2, 0}, 0}, {"c", {1, 0}, 0}});
  study.weighing.take_normals(std::make_shared<const UniformNormals>(
      std::vector<std::vector<double>>{{2}, {4}, {6}}, std::vector<std::vector<double>>{{1}}));
  // a has 3 of its normal of 2, b 1 of 4, and so around c fell (1.5 + .25) / 2 times 6, of normals
  // relative to a's.
  EXPECT_DOUBLE_EQ(around(study, 2, {3, 1, silent}), (3.0 / 1 + 1.0 / 2) / 2 * 3);
}

}  // namespace
}  // namespace thiessen
