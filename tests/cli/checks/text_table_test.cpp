#include "cli/checks/text_table.h"

#include <gtest/gtest.h>

namespace thiessen::cli {
namespace {

TEST(TextTable, the_first_column_is_flush_left_and_the_others_are_flush_right) {
  EXPECT_EQ(aligned({{"basin", "km2", "n"}, {"A", "12.50", "3"}, {"Boulder", "7.00", "12"}}),
            "basin      km2   n\n"
            "A        12.50   3\n"
            "Boulder   7.00  12\n");
}

TEST(TextTable, each_character_counts_as_one_wide) {
  EXPECT_EQ(aligned({{"\xC3\xA9t\xC3\xA9", "1"}, {"abcd", "2"}}),
            "\xC3\xA9t\xC3\xA9   1\nabcd  2\n");
  EXPECT_EQ(aligned({{"a", "\xE9\x9B\xA8"}, {"a", "22"}}), "a   \xE9\x9B\xA8\na  22\n");
}

TEST(TextTable, rows_may_be_short_and_columns_empty) {
  EXPECT_EQ(aligned({{"a", "bb"}, {"c"}}), "a  bb\nc\n");
  EXPECT_EQ(aligned({{"", "b"}, {"", "c"}}), "  b\n  c\n");
  EXPECT_EQ(aligned({}), "");
}

}  // namespace
}  // namespace thiessen::cli
