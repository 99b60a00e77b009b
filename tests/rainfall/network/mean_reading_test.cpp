#include "rainfall/network/mean_reading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();
const std::vector<StationIndex> three{StationIndex{0}, StationIndex{2}, StationIndex{3}};

TEST(MeanReading, is_of_the_stations_that_report) {
  EXPECT_EQ(mean_reading(three, std::vector{1.0, 100.0, 2.0, 6.0}), 3);
  EXPECT_EQ(mean_reading(three, std::vector{1.0, 100.0, silent, 6.0}), 3.5);
  EXPECT_EQ(mean_reading(three, std::vector{silent, 100.0, silent, 6.0}), 6);
  EXPECT_EQ(count_reporting(three, std::vector{1.0, silent, silent, 6.0}), 2u);
}

TEST(MeanReading, there_is_none_where_none_reports) {
  EXPECT_TRUE(std::isnan(mean_reading(three, std::vector{silent, 100.0, silent, silent})));
  EXPECT_TRUE(std::isnan(mean_reading(std::vector{StationIndex{0}}, std::vector{silent})));
  EXPECT_EQ(count_reporting(three, std::vector{silent, 100.0, silent, silent}), 0u);
}

// In doubles one after the other, 1e16 + 1 - 1e16 is 0.
TEST(MeanReading, does_not_depend_on_the_order_of_the_stations) {
  EXPECT_EQ(mean_reading(three, std::vector{1e16, 0.0, 3.0, -1e16}), 1);
  EXPECT_EQ(mean_reading(three, std::vector{1e16, 0.0, -1e16, 3.0}), 1);
  EXPECT_EQ(mean_reading(three, std::vector{3.0, 0.0, 1e16, -1e16}), 1);
}

TEST(MeanReading, has_one_for_each_place) {
  const Network network({{"a", {1, 1}}, {"b", {2, 2}}, {"c", {1, 1}}, {"d", {3, 3}}},
                        Metric::planar);
  const auto means = readings_by_place(network, std::vector{10.0, 7.0, 20.0, silent});
  ASSERT_EQ(means.size(), 3u);
  EXPECT_EQ(means[0], 15);
  EXPECT_EQ(means[1], 7);
  EXPECT_TRUE(std::isnan(means[2]));
}

}  // namespace
}  // namespace thiessen
