#include "rainfall/leaving_out/half_networks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "basin/shapes.h"
#include "rainfall/leaving_out/gauge_groups.h"
#include "rainfall/normals/uniform_normals.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

Basin rectangle_basin(const std::string& id, Point low, Point high) {
  return {id, {{shapes::rectangle(low, high), {}}}, {}};
}

const HalvedMethod& of(const std::vector<HalvedMethod>& methods, PointMethod method,
                       bool with_normals = false) {
  for (const HalvedMethod& m : methods) {
    if (m.method == method && m.with_normals == with_normals) return m;
  }
  ADD_FAILURE();
  return methods.front();
}

// By hand: four gauges in the middles of the quarters of a strip. All halves are every other one:
// of a, c the cells are 0..4 and 4..8 (of 8), whose mean is (a + c) / 2, and so that of b, d.
TEST(HalfNetworks, of_a_strip_by_hand) {
  const Network network({{"a", {1, 0.5}}, {"b", {3, 0.5}}, {"c", {5, 0.5}}, {"d", {7, 0.5}}},
                        Metric::planar);
  const std::vector<Basin> basins{rectangle_basin("strip", {0, 0}, {8, 1})};
  const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
  const std::vector<double> readings{10, 20, 60, 30};  // by all: 30
  const std::vector<HalvedStep> steps{{readings}};
  const auto methods = errors_with_half_the_gauges(weighing, steps, 100, 1);
  EXPECT_EQ(methods.size(), 4u);
  const ErrorSums arithmetic = of(methods, PointMethod::arithmetic).errors;
  EXPECT_EQ(arithmetic.count, 2u);
  EXPECT_NEAR(arithmetic.errors, 0, 1e-12);  // 35 - 30 and 25 - 30
  EXPECT_NEAR(arithmetic.squares, 25 + 25, 1e-9);
  const ErrorSums thiessen = of(methods, PointMethod::thiessen).errors;
  EXPECT_EQ(thiessen.count, 2u);
  // a, c: border at 3: 10 x 3/8 + 60 x 5/8 = 41.25; b, d: at 5: 20 x 5/8 + 30 x 3/8 = 23.75.
  EXPECT_NEAR(thiessen.squares, 11.25 * 11.25 + 6.25 * 6.25, 1e-9);
}

// Two gauges of the same half stand in the small basin.
TEST(HalfNetworks, where_a_half_has_no_value_are_fewer) {
  const Network network({{"a", {1, 1}}, {"b", {9, 1}}}, Metric::planar);
  const std::vector<Basin> basins{rectangle_basin("a", {0, 0}, {2, 2})};
  const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
  const std::vector<double> readings{10, 20};
  const std::vector<double> nobody{silent, silent};
  const std::vector<HalvedStep> steps{{readings}, {nobody}};
  const auto methods = errors_with_half_the_gauges(weighing, steps, 100, 1);
  EXPECT_EQ(of(methods, PointMethod::arithmetic).errors.count, 1u);
  EXPECT_EQ(of(methods, PointMethod::thiessen).errors.count, 2u);
  EXPECT_EQ(of(methods, PointMethod::thiessen).errors.squares, 100);
}

TEST(HalfNetworks, with_normals_that_say_all_have_no_error) {
  const Network network({{"a", {1, 0.5}}, {"b", {3, 0.5}}, {"c", {5, 0.5}}, {"d", {7, 0.5}}},
                        Metric::planar);
  const std::vector<Basin> basins{rectangle_basin("strip", {0, 0}, {8, 1})};
  Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
  weighing.take_normals(std::make_shared<const UniformNormals>(
      std::vector<std::vector<double>>{{100}, {200}, {600}, {300}},
      std::vector<std::vector<double>>{{250}}));
  const std::vector<double> readings{10, 20, 60, 30};
  const std::vector<HalvedStep> steps{{readings}};
  const auto methods = errors_with_half_the_gauges(weighing, steps, 100, 1);
  EXPECT_EQ(methods.size(), 8u);
  for (const HalvedMethod& m : methods) {
    EXPECT_EQ(m.errors.squares < 1e-18, m.with_normals) << name_of(m.method);
  }
  EXPECT_GT(of(methods, PointMethod::thiessen).errors.squares, 100);
}

TEST(GaugeGroups, hold_neighbours) {
  std::vector<Station> stations;
  for (int x = 0; x < 16; ++x) {
    for (int y = 0; y < 16; ++y) stations.push_back({"", {x * 1.0, y * 1.0}});
  }
  const Network network(stations, Metric::planar);
  const GaugeGroups groups(network);
  EXPECT_EQ(groups.count, 30u);
  std::vector<int> counts(groups.count);
  for (const std::size_t g : groups.of_place) ++counts[g];
  for (const int count : counts) EXPECT_NEAR(count, 8.5, 0.51);
  const auto order = along_hilbert_curve(network);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point a = network.places()[index(order[i - 1])];
    const Point b = network.places()[index(order[i])];
    EXPECT_LE(std::abs(a.x - b.x) + std::abs(a.y - b.y), 2);
  }
  EXPECT_EQ(GaugeGroups(Network({{"a", {0, 0}}, {"b", {1, 0}}}, Metric::planar)).count, 2u);
}

}  // namespace
}  // namespace thiessen
