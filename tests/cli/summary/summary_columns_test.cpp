#include "cli/summary/summary_columns.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace thiessen::cli {
namespace {

using Texts = std::vector<std::string>;

BasinSummary basin(double area, std::optional<double> mean, std::optional<double> error,
                   std::optional<double> largest) {
  BasinSummary summary;
  summary.basin = "Q";
  summary.area = area;
  summary.mean = mean;
  summary.standard_error = error;
  summary.largest = largest;
  return summary;
}

Texts values(const std::vector<BasinSummary>& basins, const std::string& heading) {
  for (const TableColumn& column : summary_columns(basins, "area km2", " mm", " mm")) {
    if (column.heading == heading) return column.values;
  }
  return {};
}

TEST(SummaryColumns, have_the_largest_depths_of_each_length) {
  std::vector<BasinSummary> basins{basin(1, 1, {}, 2), basin(1, 1, {}, 2)};
  basins[0].depths = {{"1h", 12.25, "t"}, {"24h", {}, ""}};
  basins[1].depths = {{"1h", 8.5, "t"}, {"24h", {}, ""}};
  EXPECT_EQ(values(basins, "max 1h mm"), (Texts{"12.2", "8.5"}));
  EXPECT_EQ(values(basins, "max 24h mm"), (Texts{"-", "-"}));
}

// The middle error, 0.0043, has two digits; the smallest has one.
TEST(SummaryColumns, rainfall_has_the_decimals_that_its_errors_tell_it_to) {
  const std::vector<BasinSummary> hourly{basin(1, 0.12345, 0.0043, 8.5), basin(1, 0.2, 0.0612, 9),
                                         basin(1, 0.1, 0.0012, 7)};
  EXPECT_EQ(values(hourly, "mean mm"), (Texts{"0.1235", "0.2000", "0.1000"}));
  EXPECT_EQ(values(hourly, "std. error mm"), (Texts{"0.0043", "0.0612", "0.0012"}));
  EXPECT_EQ(values(hourly, "largest mm"), (Texts{"8.5000", "9.0000", "7.0000"}));
  const std::vector<BasinSummary> yearly{basin(1, 843.25, 41.6, 1135.39)};
  EXPECT_EQ(values(yearly, "mean mm"), Texts{"843"});
  const std::vector<BasinSummary> one_is_small{
      basin(1, 43.25, 8.03, 135.39), basin(1, 43.25, 7, 135.39), basin(1, 43.25, 0.03, 135.39)};
  EXPECT_EQ(values(one_is_small, "std. error mm"), (Texts{"8.03", "7.00", "0.03"}));
}

TEST(SummaryColumns, without_errors_three_digits_of_the_mean_are_shown) {
  EXPECT_EQ(values({basin(1, 69.836, {}, 69.836)}, "mean mm"), Texts{"69.8"});
  EXPECT_EQ(values({basin(1, 69.836, {}, 69.836)}, "std. error mm"), Texts{"-"});
  EXPECT_EQ(values({basin(1, {}, {}, {})}, "mean mm"), Texts{"-"});
  EXPECT_EQ(values({basin(1, 0, {}, 0)}, "mean mm"), Texts{"0"});
  EXPECT_EQ(values({basin(1, 1e-9, {}, 1)}, "mean mm"), Texts{"0.000000"});
}

TEST(SummaryColumns, the_most_influential_gauge_stands_beside_what_it_changes) {
  BasinSummary with = basin(125, 1, {}, 1);
  with.most_influential = "B";
  with.influence = 9.4868;
  EXPECT_EQ(values({with, basin(40, 1, {}, 1)}, "most influential gauge"), (Texts{"B", "-"}));
  EXPECT_EQ(values({with, basin(40, 1, {}, 1)}, "moves it mm"), (Texts{"9.5", "-"}));
  EXPECT_EQ(values({with, basin(40, 1, {}, 1)}, "area km2"), (Texts{"125.0", "40.0"}));
}

}  // namespace
}  // namespace thiessen::cli
