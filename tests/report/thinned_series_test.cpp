#include "report/thinned_series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(ThinnedSeries, keeps_a_short_series_as_it_is) {
  ThinnedSeries series(1, 1);
  series.add("first", std::vector{1.5}, std::vector{2.0});
  series.add("second", std::vector{none}, std::vector{none});
  ASSERT_EQ(series.stretches().size(), 2U);
  EXPECT_EQ(series.steps_in_a_stretch(), 1U);
  EXPECT_EQ(series.stretches()[0].time, "first");
  EXPECT_EQ(series.stretches()[0].basins[0].largest, 1.5);
  EXPECT_EQ(series.stretches()[1].basins[0].values, 0U);
  EXPECT_TRUE(std::isnan(series.stretches()[1].readings[0]));
}

TEST(ThinnedSeries, keeps_the_extremes_of_a_long_one) {
  ThinnedSeries series(2, 1);
  // 1 everywhere, but for one step of 9 and one of 0, at other times in the two basins.
  for (std::size_t i = 0; i < 100'000; ++i) {
    const double a = i == 31'415 ? 9 : i == 77'777 ? 0 : 1;
    const double b = i == 99'999 ? 9 : i == 0 ? 0 : 1;
    series.add(std::to_string(i), std::vector{a, b}, std::vector{a + b});
  }
  EXPECT_EQ(series.steps(), 100'000U);
  EXPECT_LE(series.stretches().size(), 4'000U);
  for (std::size_t b = 0; b < 2; ++b) {
    double least = 1;
    double largest = 1;
    double sum = 0;
    std::size_t steps = 0;
    for (const SeriesStretch& stretch : series.stretches()) {
      least = std::min(least, stretch.basins[b].least);
      largest = std::max(largest, stretch.basins[b].largest);
      sum += stretch.basins[b].sum;
      steps += stretch.steps;
    }
    EXPECT_EQ(least, 0);
    EXPECT_EQ(largest, 9);
    EXPECT_EQ(sum, 100'000 + 8 - 1);
    EXPECT_EQ(steps, 100'000U);
  }
}

TEST(ThinnedSeries, shows_the_wettest_step_of_a_stretch) {
  ThinnedSeries series(1, 2, {.values = 1, .most = 1, .fewest = 1});
  series.add("dry", std::vector{0.0}, std::vector{0.0, 0.0});
  series.add("wet", std::vector{5.0}, std::vector{6.0, none});
  series.add("damp", std::vector{1.0}, std::vector{1.0, 1.0});
  ASSERT_EQ(series.stretches().size(), 2U);
  EXPECT_EQ(series.steps_in_a_stretch(), 2U);
  EXPECT_EQ(series.stretches()[0].begin, "dry");
  EXPECT_EQ(series.stretches()[0].time, "wet");
  EXPECT_EQ(series.stretches()[0].readings[0], 6);
  EXPECT_EQ(series.stretches()[1].begin, "damp");
  EXPECT_EQ(series.stretches()[1].time, "damp");
}

TEST(ThinnedSeries, counts_silences) {
  ThinnedSeries series(1, 2, {.readings = 1});
  for (const double reading : {none, 1.0, none, none, 2.0})
    series.add("t", std::vector{1.0}, std::vector{reading, 1.0});
  EXPECT_EQ(series.silent_steps(), (std::vector<std::size_t>{3, 0}));
  EXPECT_EQ(series.longest_silences(), (std::vector<std::size_t>{2, 0}));
  EXPECT_FALSE(series.has_readings());
  EXPECT_TRUE(series.stretches()[0].readings.empty());
}

}  // namespace
}  // namespace thiessen
