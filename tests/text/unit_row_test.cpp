#include "text/unit_row.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

using Fields = std::vector<std::string_view>;

TEST(UnitRow, has_units_and_words_without_digits_alone) {
  const auto row = unit_row(Fields{"", "mm", "[degC]", "MM", "mm", "remarks"});
  ASSERT_TRUE(row);
  EXPECT_EQ(row->units, "mm, [degC], MM");
  EXPECT_EQ(row->of_column, (std::vector<std::string>{"", "mm", "degC", "MM", "mm", ""}));
  EXPECT_TRUE(unit_row(Fields{"UTC", "0.1 mm"})) << "a digit of a unit";
}

TEST(UnitRow, is_none_where_a_number_or_no_unit_stands_in_it) {
  EXPECT_FALSE(unit_row(Fields{"2020-01-01", "mm"}));
  EXPECT_FALSE(unit_row(Fields{"a", "b"}));
  EXPECT_FALSE(unit_row(Fields{"mm"})) << "a table of one column has none";
  EXPECT_FALSE(unit_row(Fields{}));
}

}  // namespace
}  // namespace thiessen
