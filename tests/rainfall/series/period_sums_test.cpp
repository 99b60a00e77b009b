#include "rainfall/series/period_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(PeriodSums, sum_what_has_a_value_and_count_what_lacks_one) {
  PeriodSums sums(std::nullopt, Stamp::begin, nullptr);
  std::vector<BasinTotal> totals;
  for (int period = 0; period < 2; ++period) {
    sums.begin(2);
    sums.add(std::vector<BasinRainfall>{{1, 1, 1}, {none, 1, 1}}, {});
    sums.add(std::vector<BasinRainfall>{{2, 1, 1}, {none, 1, 1}}, {});
    sums.lack(0, 3);
    sums.totals(1, totals);
    ASSERT_EQ(totals.size(), 2U);
    EXPECT_EQ(totals[0].rainfall, 3);
    EXPECT_EQ(totals[0].missing, 3U);
    EXPECT_TRUE(std::isnan(totals[1].rainfall));
    EXPECT_EQ(totals[1].missing, 2U);
  }
  sums.totals(0.25, totals);
  EXPECT_EQ(totals[0].rainfall, 0.75);
}

}  // namespace
}  // namespace thiessen
