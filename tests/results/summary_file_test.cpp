#include "results/summary_file.h"

#include <gtest/gtest.h>

#include <vector>

#include "results/written.h"

namespace thiessen {
namespace {

TEST(SummaryFile, has_a_row_a_basin_and_nothing_where_there_is_no_value) {
  BasinSummary wet;
  wet.basin = "B,1";
  wet.area = 0.1;
  wet.gauges_inside = 2;
  wet.gauges_weighing = 3;
  wet.largest_weight = 0.5;
  wet.mean = 1.0 / 3;
  wet.standard_error = 0.004;
  wet.largest = 12.5;
  wet.empty_steps = 1;
  wet.most_influential = "007";
  wet.influence = 0.25;
  BasinSummary silent;
  silent.basin = "C";
  silent.area = 4;
  silent.empty_steps = 7;
  const std::vector<BasinSummary> basins{wet, silent};
  EXPECT_EQ(written([&](OutputFile& file) { write_summary(file, basins, AreaUnit{1e-6}); }),
            "basin,area_km2,gauges_inside,gauges_weighing,largest_weight,mean,standard_error,"
            "largest,empty_steps,most_influential,influence\n"
            "\"B,1\",0.1,2,3,0.5,0.3333333333333333,0.004,12.5,1,007,0.25\n"
            "C,4,0,0,0,,,,7,,\n");
}

TEST(SummaryFile, has_the_largest_depths_behind_all_others) {
  BasinSummary wet;
  wet.basin = "B";
  wet.depths = {{"1h", 4.5, "2020-05-01T03:00"}, {"24h", {}, ""}};
  const std::vector<BasinSummary> basins{wet};
  EXPECT_EQ(written([&](OutputFile& file) { write_summary(file, basins, AreaUnit{1}); }),
            "basin,area,gauges_inside,gauges_weighing,largest_weight,mean,standard_error,largest,"
            "empty_steps,most_influential,influence,max_1h,max_1h_time,max_24h,max_24h_time\n"
            "B,0,0,0,0,,,,0,,,4.5,2020-05-01T03:00,,\n");
}

TEST(SummaryFile, does_not_call_an_unknown_unit_square_kilometres) {
  EXPECT_TRUE(written([](OutputFile& file) {
                write_summary(file, {}, AreaUnit{1});
              }).starts_with("basin,area,gauges_inside,"));
}

}  // namespace
}  // namespace thiessen
