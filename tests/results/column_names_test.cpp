#include "results/column_names.h"

#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

std::vector<Basin> basins(const std::vector<std::string>& ids) {
  std::vector<Basin> all;
  for (const std::string& id : ids) all.push_back({id, {}, {}});
  return all;
}

TEST(ColumnNames, may_look_alike_as_long_as_no_two_are_the_same) {
  EXPECT_NO_THROW(check_column_names(basins({"A", "B", "a_se", "A_SE", "_se"}), "_se"));
  EXPECT_NO_THROW(check_column_names(basins({"A", "A_missing"}), "_se"));
  EXPECT_NO_THROW(check_column_names({}, "_se"));
}

TEST(ColumnNames, of_a_basin_may_not_be_anothers_with_the_suffix_wherever_it_stands) {
  const std::string fault =
      "basins 'A' and 'A_se' would both have a column of the latter name | 'long' has a row a "
      "basin, and 'basin_id' takes the ids of another field";
  for (const auto& ids : {std::vector<std::string>{"A", "B", "A_se"}, {"A_se", "A"}})
    EXPECT_EQ(complaint_of([&] { check_column_names(basins(ids), "_se"); }), fault);
  EXPECT_EQ(complaints_of([&] { check_column_names(basins({"", "_se"}), "_se"); }).size(), 1U);
}

TEST(ColumnNames, of_a_basin_may_not_be_that_of_the_times) {
  EXPECT_NO_THROW(check_time_column(basins({"A", "Time", "time ", "times"})));
  EXPECT_EQ(complaint_of([] {
              check_time_column(basins({"A", "time"}));
            }),
            "the column of basin 'time' would be called as that of times | 'long' has a row a "
            "basin, and 'basin_id' takes the ids of another field");
}

}  // namespace
}  // namespace thiessen
