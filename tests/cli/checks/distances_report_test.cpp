#include "cli/checks/distances_report.h"

#include <gtest/gtest.h>

#include <string>

#include "cli/checks/text_table.h"
#include "cli/outputs/given_inputs.h"

namespace thiessen::cli {
namespace {

TEST(NearestGaugesTable, has_the_farthest_basin_first_and_says_which_gauges_are_inside) {
  GivenFiles files;
  files.basins += "R,\"POLYGON ((11 0,12 0,12 4,11 4,11 0))\"\n";
  files.basins += "S,\"POLYGON ((20 0,24 0,24 4,20 4,20 0))\"\n";
  const GivenInputs given(files);
  EXPECT_EQ(nearest_gauges_table(given.inputs),
            "the nearest gauge of each basin, the farthest first:\n" +
                aligned({{"basin", "gauges inside", "nearest gauge", "distance"},
                         {"'S'", "0", "'B'", "12.0 units"},
                         {"'R'", "0", "'B'", "3.00 units"},
                         {"'Q'", "2", "'A'", "inside"}}));
}

TEST(OddGauges, are_none_where_nothing_is_odd) {
  EXPECT_EQ(odd_gauges_text(GivenInputs().inputs), "");
}

// Four in five gauges are a unit from the next one, and the last is 100.
TEST(OddGauges, are_those_far_from_all_others) {
  GivenFiles files;
  files.stations = "id,x,y\nA,0,2\nB,1,2\nC,2,2\nD,3,2\nE,4,2\nF,104,2\n";
  EXPECT_EQ(odd_gauges_text(GivenInputs(files).inputs),
            "gauges far from all others: 'F' (100 units)\n");
}

TEST(OddGauges, at_0_0_of_a_known_crs_are_named_up_to_twenty) {
  GivenFiles files = files_in_degrees();
  for (int i = 1; i <= 21; ++i) files.stations += "z" + std::to_string(i) + ",0,0\n";
  const std::string text = odd_gauges_text(GivenInputs(files).inputs);
  const std::string start = "gauges at 0, 0, as missing coordinates are often written: 'z1', 'z2'";
  EXPECT_TRUE(text.starts_with(start)) << text;
  EXPECT_NE(text.find(", 'z20' and 1 more\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace thiessen::cli
