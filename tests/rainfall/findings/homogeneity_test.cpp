#include "rainfall/findings/homogeneity.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace thiessen {
namespace {

TEST(MeanChange, is_where_the_mean_changes) {
  // Mean 1/2, variance 6/4/5 = 0.3; three deviations of -1/2 before: 2.25/0.3 (1/3 + 1/3) = 5.
  const std::vector<double> values{0, 0, 0, 1, 1, 1};
  const MeanChange found = mean_change(values, 1);
  EXPECT_EQ(found.at, 3u);
  EXPECT_NEAR(found.statistic, 5, 1e-12);
}

TEST(MeanChange, leaves_so_many_values_on_either_side) {
  // The first of five alone differs: with two on a side the change is after the second.
  const std::vector<double> values{1, 0, 0, 0, 0};
  EXPECT_EQ(mean_change(values, 1).at, 1u);
  EXPECT_EQ(mean_change(values, 2).at, 2u);
  EXPECT_EQ(mean_change(values, 3).statistic, 0);
}

TEST(MeanChange, is_none_of_equal_values) {
  EXPECT_EQ(mean_change(std::vector<double>(20, 3.5), 3).statistic, 0);
  EXPECT_EQ(mean_change({}, 0).statistic, 0);
}

TEST(MeanChange, is_above_12_in_about_one_of_a_hundred_series_without_one) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const std::size_t years : {15u, 30u, 100u}) {
    int above = 0;
    for (int i = 0; i < 2000; ++i) {
      std::vector<double> values(years);
      for (double& value : values) value = normal(random);
      above += mean_change(values, 3).statistic > 12 ? 1 : 0;
    }
    EXPECT_LE(above, 40) << years;
  }
}

}  // namespace
}  // namespace thiessen
