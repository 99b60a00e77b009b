#include "cli/outputs/rain_table.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "results/written.h"

namespace thiessen::cli {
namespace {

RainStep step(const std::string& time, double rainfall) {
  RainStep step;
  step.time = time;
  step.basins = {{rainfall, 2, 1}};
  return step;
}

/// What is written of two steps of one basin.
std::string table(const RainFormat& format, const std::optional<Totalling>& totalling,
                  bool prepared = true) {
  const std::vector<Basin> basins = {{"A", {}, {}}};
  return written([&](OutputFile& file) {
    RainTable rain(file, basins, format, totalling, "r.csv");
    std::size_t pattern = 0;
    for (RainStep next : {step("2013-08-01", 1.5), step("2013-08-02", 2)}) {
      if (prepared) rain.prepare(next);
      rain.add(next, ++pattern);
    }
    Warnings warnings;
    rain.finish(warnings);
  });
}

TEST(RainTable, has_the_steps_where_no_totals_are_wanted) {
  EXPECT_EQ(table({}, std::nullopt), "time,A\n2013-08-01,1.500\n2013-08-02,2.000\n");
}

TEST(RainTable, has_totals_of_periods_where_they_are) {
  EXPECT_EQ(table({}, Totalling{PeriodUnit::day, 0}),
            "time,A,A_missing\n2013-08-01,1.500,0\n2013-08-02,2.000,0\n");
  const std::string month = table({}, Totalling{PeriodUnit::month, 31});
  EXPECT_TRUE(month.starts_with("time,A,A_missing\n2013-08,3.500,")) << month;
}

// The number of a pattern is known only when the steps come in their order.
TEST(RainTable, writes_patterns_that_are_not_known_ahead_of_time) {
  RainFormat format;
  format.rows_for_basins = true;
  format.patterns = true;
  const std::string rows =
      "time,basin,rainfall,gauges,coverage,pattern\n"
      "2013-08-01,A,1.500,2,1,1\n2013-08-02,A,2.000,2,1,2\n";
  EXPECT_EQ(table(format, std::nullopt), rows);
  EXPECT_EQ(table(format, std::nullopt, false), rows);
}

}  // namespace
}  // namespace thiessen::cli
