#include "results/rain_totals_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/complaints.h"
#include "results/written.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string totals(const std::vector<Basin>& basins, const RainFormat& format) {
  return written([&](OutputFile& file) {
    RainTotalsFile totals(file, basins, format);
    totals.add({"2013-08", {{12.5, 0}, {none, 3}}});
  });
}

TEST(RainTotalsFile, has_a_total_and_the_missing_steps_of_each_basin_side_by_side) {
  const std::vector<Basin> basins = {{"A", {}, {}}, {"B", {}, {}}};
  EXPECT_EQ(totals(basins, {}), "time,A,A_missing,B,B_missing\n2013-08,12.500,0,,3\n");
  RainFormat format;
  format.rows_for_basins = true;
  EXPECT_EQ(totals(basins, format),
            "time,basin,rainfall,missing\n2013-08,A,12.500,0\n2013-08,B,,3\n");
}

TEST(RainTotalsFile, rows_of_storms_have_the_time_of_the_last_wet_step) {
  const std::vector<Basin> basins = {{"A", {}, {}}};
  RainFormat format;
  format.rows_for_basins = true;
  format.storms = true;
  EXPECT_EQ(written([&](OutputFile& file) {
              RainTotalsFile totals(file, basins, format);
              totals.add({"2013-08-01T03:00", {{12.5, 0}}, {}, "2013-08-01T07:00"});
            }),
            "time,last,basin,rainfall,missing\n2013-08-01T03:00,2013-08-01T07:00,A,12.500,0\n");
}

TEST(RainTotalsFile, two_columns_of_one_name_are_refused) {
  const std::vector<Basin> basins = {{"A", {}, {}}, {"A_missing", {}, {}}};
  const auto faults = complaints_of([&] { totals(basins, {}); });
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].find("basins 'A' and 'A_missing' would both have a column"),
            std::string::npos);
}

}  // namespace
}  // namespace thiessen
