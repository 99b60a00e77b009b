#include "rainfall/totals/total_spreading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double nobody = std::numeric_limits<double>::quiet_NaN();

struct Spread {
  SpreadBy by;
  std::vector<double> amounts;
};

Spread spread(double total, const std::vector<double>& around) {
  std::vector<double> amounts(around.size());
  const SpreadBy by = spread_total(total, around, amounts);
  return {by, amounts};
}

TEST(TotalSpreading, is_in_proportion_to_what_fell_around) {
  const Spread found = spread(12, {1, 0, 3, 2});
  EXPECT_EQ(found.by, SpreadBy::gauges);
  EXPECT_EQ(found.amounts, (std::vector<double>{2, 0, 6, 4}));
}

TEST(TotalSpreading, gives_nothing_to_steps_that_nobody_reported) {
  const Spread found = spread(12, {1, nobody, 3});
  EXPECT_EQ(found.by, SpreadBy::gauges);
  EXPECT_EQ(found.amounts[0], 3);
  EXPECT_TRUE(std::isnan(found.amounts[1]));
  EXPECT_EQ(found.amounts[2], 9);
}

TEST(TotalSpreading, is_even_over_what_was_reported_where_it_was_dry_around) {
  const Spread found = spread(3, {0, nobody, 0});
  EXPECT_EQ(found.by, SpreadBy::evenly_dry);
  EXPECT_EQ(found.amounts[0], 1.5);
  EXPECT_TRUE(std::isnan(found.amounts[1]));
  EXPECT_EQ(found.amounts[2], 1.5);
}

TEST(TotalSpreading, is_even_over_all_steps_where_nobody_reported) {
  const Spread found = spread(3, {nobody, nobody});
  EXPECT_EQ(found.by, SpreadBy::evenly_unreported);
  EXPECT_EQ(found.amounts, (std::vector<double>{1.5, 1.5}));
}

TEST(TotalSpreading, of_nothing_is_zeros) {
  EXPECT_EQ(spread(0, {1, 2}).amounts, (std::vector<double>{0, 0}));
  EXPECT_EQ(spread(0, {0, 0}).amounts, (std::vector<double>{0, 0}));
}

TEST(TotalSpreading, needs_steps) {
  EXPECT_EQ(spread(3, {}).by, SpreadBy::nothing);
}

TEST(TotalSpreading, adds_up_to_the_total_however_small_or_large_the_rain_around) {
  Seeded seeded;
  for (int round = 0; round < 200; ++round) {
    const double total = seeded.uniform(0.1, 300);
    const double size = std::pow(10, seeded.uniform(-300, 300));
    std::vector<double> around(1 + seeded.below(800));
    for (double& rain : around) rain = seeded.below(3) == 0 ? size * seeded.uniform(0, 1) : 0;
    const Spread found = spread(total, around);
    const double sum = std::accumulate(found.amounts.begin(), found.amounts.end(), 0.0);
    EXPECT_NEAR(sum, total, 1e-12 * total);
    for (const double amount : found.amounts) EXPECT_GE(amount, 0);
  }
}

}  // namespace
}  // namespace thiessen
