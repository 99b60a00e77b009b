#include "rainfall/normals/raster_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "basin/shapes.h"
#include "geometry/seeded.h"
#include "rainfall/network/weights.h"
#include "rainfall/normals/plane_raster.h"

namespace thiessen {
namespace {

constexpr Yardstick plane{Metric::planar, 1, 0.1};
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Two gauges, at (2, 2) and (6, 2), in a basin of 8 by 4: each has half of it.
struct TwoHalves {
  Network network{{{"a", {2, 2}, 2}, {"b", {6, 2}, 3}}, Metric::planar};
  std::vector<Basin> basins{shapes::basin({{shapes::rectangle({0, 0}, {8, 4}), {}}})};
  Weighing weighing{network, basins, plane};
  ReportingStations all{true, true};

  explicit TwoHalves(const plane_raster::Raster& raster) {
    weighing.take_normals(plane_raster::normals_of(raster, network, basins));
  }
};

// Pixels have the value of x at their centres: the means of the halves are 2 and 6, and the gauges'
// pixels have 2.5 and 6.5.
TEST(RasterNormals, of_a_slope_are_its_means_over_the_halves) {
  const TwoHalves study({8, 4, [](double x, double, std::size_t) { return x + 0.5; }});
  const auto weights = study.weighing.weights(study.all, 1)[0].stations;
  ASSERT_EQ(weights.size(), 2u);
  EXPECT_DOUBLE_EQ(weights[0].weight, 0.5);
  EXPECT_DOUBLE_EQ(weights[0].factor, 2 / 2.5);
  EXPECT_DOUBLE_EQ(weights[1].factor, 6 / 6.5);
}

TEST(RasterNormals, that_are_the_same_everywhere_have_factors_of_exactly_one) {
  const TwoHalves study({8, 4, [](double, double, std::size_t) { return 0.1; }});
  const auto weights = study.weighing.weights(study.all, 1);
  for (const StationWeight& s : weights[0].stations) EXPECT_EQ(s.factor, 1);
}

// The upper half of the left half has none: its mean is that of the lower, 10. The right half has
// none but at the gauge: it takes the basin's mean.
TEST(RasterNormals, that_are_missing_take_the_mean_of_the_rest_of_the_ground) {
  const TwoHalves lower({8, 4, [](double x, double y, std::size_t) {
                           return x < 4 ? (y < 2 ? 10 : (x == 2 && y == 2 ? 20 : none)) : 5;
                         }});
  const auto weights = lower.weighing.weights(lower.all, 1)[0].stations;
  // 8 pixels of 10 and one of 20
  EXPECT_DOUBLE_EQ(weights[0].factor, (8 * 10 + 20) / 9.0 / 20);
  EXPECT_DOUBLE_EQ(weights[1].factor, 1);
}

TEST(RasterNormals, of_ground_without_any_are_those_of_the_basin) {
  const Network network({{"a", {2, 2}, 2}, {"b", {9, 2}, 3}}, Metric::planar);
  const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({0, 0}, {8, 4}), {}}})};
  Weighing weighing(network, basins, plane);
  weighing.take_normals(plane_raster::normals_of(
      {12, 4, [](double x, double, std::size_t) { return x < 4 || x > 8 ? 10 + x : none; }},
      network, basins));
  const auto weights = weighing.weights({true, true}, 1)[0].stations;
  const double mean = 11.5;  // of 10, 11, 12 and 13
  EXPECT_DOUBLE_EQ(weights[0].factor, mean / 12);
  EXPECT_DOUBLE_EQ(weights[1].factor, mean / 19);
}

// Months of 1 and 3 at the first gauge and of 1 and 9 at the second: years of 2 and 5.
TEST(RasterNormals, of_months_make_those_of_the_year) {
  const TwoHalves study(
      {8, 4, [](double x, double, std::size_t m) { return m == 0 ? 1.0 : (x < 4 ? 3.0 : 9.0); },
       2});
  const auto months = study.weighing.weights_by_month(study.all, 1);
  ASSERT_EQ(months.size(), 2u);
  for (const auto& month : months) EXPECT_DOUBLE_EQ(month[0].stations[1].factor, 1);
  const NormalField& normals = *study.weighing.normals();
  EXPECT_DOUBLE_EQ(normal_at_gauge(normals, StationIndex{1}, {}), 5);
  EXPECT_DOUBLE_EQ(relative_at_gauge(normals, StationIndex{1}, {}), 2.5);
  EXPECT_DOUBLE_EQ(normal_at_gauge(normals, StationIndex{1}, 1), 9);
  EXPECT_DOUBLE_EQ(normal_at(normals, 0, {5, 1}, {}), 5);
  EXPECT_TRUE(std::isnan(normal_at(normals, 0, {8.5, 1}, {})));
}

// Law: over all cells of a basin the sum of weight x mean normal does not depend on the gauges.
TEST(RasterNormals, add_up_to_those_of_the_basin) {
  Seeded seeded;
  const plane_raster::Raster raster{30, 30, [](double x, double y, std::size_t) {
                                      return 500 + 100 * std::sin(x) + 90 * std::cos(3 * y);
                                    }};
  for (std::uint64_t round = 0; round < Seeded::rounds(20); ++round) {
    const std::vector<Basin> basins{shapes::basin({{shapes::star(seeded, {15, 15}, 14, 25), {}}})};
    std::vector<double> means;
    for (const int count : {1, 25}) {
      std::vector<Station> stations;
      for (int i = 0; i < count; ++i)
        stations.push_back({std::to_string(i), {seeded.uniform(0, 30), seeded.uniform(0, 30)}, 0});
      const Network network(stations, Metric::planar);
      Weighing weighing(network, basins, plane);
      weighing.take_normals(plane_raster::normals_of(raster, network, basins));
      double mean = 0;
      const auto weights = weighing.weights(ReportingStations(stations.size(), true), 1);
      for (const StationWeight& s : weights[0].stations) {
        mean += s.weight * s.factor *
                plane_raster::value_at(raster, network.stations()[index(s.station)].position, 0);
      }
      means.push_back(mean);
    }
    EXPECT_NEAR(means[0], means[1], 1e-10 * means[0]);
  }
}

}  // namespace
}  // namespace thiessen
