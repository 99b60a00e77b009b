#include "rainfall/network/network_dual.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace thiessen {
namespace {

constexpr Yardstick plane{Metric::planar, 1, 0.1};
constexpr double never_ends = std::numeric_limits<double>::infinity();

Network network_of(const std::vector<Point>& positions) {
  std::vector<Station> stations;
  for (const Point p : positions) stations.push_back({std::to_string(stations.size()), p, 0});
  return {std::move(stations), Metric::planar};
}

constexpr StationIndex station(std::uint32_t i) {
  return StationIndex{i};
}

void expect_borders(const NetworkDual& dual, const std::vector<StationBorder>& expected) {
  ASSERT_EQ(dual.borders.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(dual.borders[i].station, expected[i].station) << i;
    EXPECT_EQ(dual.borders[i].neighbour, expected[i].neighbour) << i;
    EXPECT_EQ(dual.borders[i].length, expected[i].length) << i;
  }
}

// A right triangle of 3, 4 and 5, with a second gauge at two of its corners.
TEST(NetworkDual, names_the_first_station_of_each_place) {
  const Network network = network_of({{0, 3}, {0, 0}, {0, 3}, {4, 0}, {0, 0}});
  const NetworkDual dual = network_dual(network, ReportingStations(5, true), plane, 1);
  EXPECT_EQ(dual.places, 3U);
  EXPECT_EQ(dual.left_out, 2U);
  ASSERT_EQ(dual.triangles.size(), 1U);
  EXPECT_EQ(dual.triangles[0], (std::array{station(0), station(1), station(3)}))
      << "counter-clockwise, from the first";
  expect_borders(dual, {{station(0), station(1), never_ends},
                        {station(0), station(3), never_ends},
                        {station(1), station(3), never_ends}});
}

TEST(NetworkDual, is_of_the_gauges_that_report) {
  const Network network = network_of({{0, 3}, {0, 0}, {0, 3}, {4, 0}, {0, 0}});
  const NetworkDual dual = network_dual(network, {false, true, true, false, false}, plane, 1);
  EXPECT_EQ(dual.places, 2U);
  EXPECT_EQ(dual.left_out, 0U);
  EXPECT_TRUE(dual.triangles.empty());
  expect_borders(dual, {{station(1), station(2), never_ends}});
  EXPECT_EQ(network_dual(network, ReportingStations(5, false), plane, 1).places, 0U);
}

}  // namespace
}  // namespace thiessen
