#include "rainfall/influence/cell_readings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "earth/yardstick.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

// Four places on a line, two stations at the second; blocks of different lengths.
TEST(CellReadings, are_means_and_components_by_step) {
  const Network network(
      {{"a", {0, 0}, 0}, {"b", {1, 0}, 0}, {"c", {2, 0}, 0}, {"d", {3, 0}, 0}, {"e", {1, 0}, 0}},
      Metric::planar);
  const Box frame{{-1, -1}, {4, 1}};
  const NetworkCells cells(network, ReportingStations(5, true), {Metric::planar, 1, 0.1}, frame, 1);
  const CellAdjacency adjacency(cells.diagram());
  CellReadings readings(cells, adjacency);
  const std::vector<std::vector<double>> steps{
      {1, 2, 3, 4, 6}, {silent, 2, silent, silent, silent}, {silent, silent, 3, 4, silent}};
  for (const std::size_t count : {3u, 1u, 2u}) {
    const std::vector<std::span<const double>> rows(steps.begin(),
                                                    steps.begin() + static_cast<int>(count));
    readings.take_up(rows, 2);
    ASSERT_EQ(readings.steps(), count);
    EXPECT_EQ(readings.of(PlaceIndex{1})[0], 4);
    EXPECT_EQ(readings.of(PlaceIndex{3})[0], 4);
    EXPECT_EQ(readings.reporting(0), 5u);
    if (count < 2) continue;
    EXPECT_EQ(readings.of(PlaceIndex{1})[1], 2);
    EXPECT_TRUE(std::isnan(readings.of(PlaceIndex{0})[1]));
    EXPECT_EQ(readings.reporting(1), 1u);
    const std::vector<PlaceIndex> east{PlaceIndex{2}, PlaceIndex{3}};
    EXPECT_EQ(readings.component_of(PlaceIndex{0}, 1), std::vector<PlaceIndex>{PlaceIndex{0}});
    EXPECT_EQ(readings.component_of(PlaceIndex{2}, 1), east);
    EXPECT_EQ(readings.component_of(PlaceIndex{3}, 1), east);
    if (count < 3) continue;
    const std::vector<PlaceIndex> west{PlaceIndex{0}, PlaceIndex{1}};
    EXPECT_EQ(readings.component_of(PlaceIndex{1}, 2), west);
  }
}

}  // namespace
}  // namespace thiessen
