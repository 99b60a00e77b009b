// A table of rain that grows: replaced by a longer one, or in place.
#include "cli/outputs/grown_table.h"

#include <gtest/gtest.h>

#include "base/temporary_folder.h"

namespace thiessen::cli {
namespace {

const char* const there = "time,A\n2020,1.000\n2021,2";

/// Adds a step to a table of one basin, and finishes unless told otherwise.
std::string grown(const TemporaryFolder& folder, bool in_place, bool finishes = true) {
  const std::vector<Basin> basins = {{"A", {}, {}}};
  RainFormat format;
  Warnings warnings;
  {
    GrownTable table(folder.path("r.csv"), {}, in_place);
    OutputFile& file = table.begin(basins, format, false, warnings);
    EXPECT_TRUE(format.continues);
    EXPECT_FALSE(table.growth()->lacks("2020", std::vector{1.0}));
    EXPECT_TRUE(table.growth()->lacks("2021", std::vector{2.5}));
    file.append("2021,2.500\n");
    table.pass_on(warnings);
    if (finishes) table.finish(warnings);
  }
  return folder.read("r.csv");
}

TEST(GrownTable, is_replaced_by_a_longer_one_or_not_at_all) {
  const TemporaryFolder folder;
  folder.write("r.csv", there);
  EXPECT_EQ(grown(folder, false, false), there);
  EXPECT_EQ(grown(folder, false), "time,A\n2020,1.000\n2021,2.500\n");
  EXPECT_EQ(folder.names(), std::set<std::string>{"r.csv"});
}

TEST(GrownTable, grows_in_place_and_keeps_what_was_passed_on) {
  const TemporaryFolder folder;
  folder.write("r.csv", there);
  EXPECT_EQ(grown(folder, true, false), "time,A\n2020,1.000\n2021,2.500\n");
}

TEST(GrownTable, begins_with_a_header_where_there_is_none) {
  const std::vector<Basin> basins = {{"A", {}, {}}};
  for (const bool in_place : {false, true}) {
    const TemporaryFolder folder;
    if (in_place) folder.write("r.csv", "");
    RainFormat format;
    Warnings warnings;
    {
      GrownTable table(folder.path("r.csv"), {}, in_place);
      OutputFile& file = table.begin(basins, format, false, warnings);
      EXPECT_FALSE(format.continues);
      file.append("time,A\n");
      EXPECT_TRUE(table.growth()->lacks("2020", std::vector{1.0}));
      file.append("2020,1.000\n");
      table.finish(warnings);
    }
    EXPECT_EQ(folder.read("r.csv"), "time,A\n2020,1.000\n");
    ASSERT_EQ(warnings.notices().size(), 1U);
  }
}

}  // namespace
}  // namespace thiessen::cli
