#include "rainfall/series/rain_statistics.h"

#include <gtest/gtest.h>

#include <limits>

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

BasinRainfall rain(double value) {
  return {value, 1, 1};
}

TEST(RainStatistics, steps_without_a_value_count_apart_and_weigh_nothing) {
  RainStatistics statistics(2);
  statistics.add({rain(2), rain(none)});
  statistics.add({rain(none), rain(none)});
  statistics.add({rain(5), rain(none)});
  EXPECT_EQ(statistics.steps(), 3U);
  EXPECT_EQ(statistics.basins()[0].mean(), 3.5);
  EXPECT_EQ(statistics.basins()[0].largest, 5);
  EXPECT_EQ(statistics.basins()[0].empty, 1U);
  EXPECT_EQ(statistics.basins()[1].values, 0U);
  EXPECT_EQ(statistics.basins()[1].empty, 3U);
}

TEST(RainStatistics, the_largest_of_negative_values_is_negative) {
  RainStatistics statistics(1);
  statistics.add({rain(-3)});
  statistics.add({rain(-7)});
  EXPECT_EQ(statistics.basins()[0].largest, -3);
}

}  // namespace
}  // namespace thiessen
