#include "cli/summary/fitted_table.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace thiessen::cli {
namespace {

TEST(FittedTable, sets_names_flush_left_numbers_flush_right_and_words_below_each_other) {
  EXPECT_EQ(
      fitted(
          {{"basin", {"Boulder", "A"}, true}, {"area km2", {"12.50", "7.00"}}, {"n", {"3", "12"}}},
          80),
      "          area\n"
      "basin      km2   n\n"
      "Boulder  12.50   3\n"
      "A         7.00  12\n");
}

TEST(FittedTable, words_share_a_line_where_the_values_are_wide) {
  EXPECT_EQ(fitted({{"mean in mm", {"1234567890"}}}, 80), "mean in mm\n1234567890\n");
  EXPECT_EQ(fitted({{"mean in mm", {"1234567"}}}, 80), "mean in\n     mm\n1234567\n");
}

// 10 + 2 + 4 are 16 characters: one blank less makes 15, and of the rest the name gives one.
TEST(FittedTable, too_wide_a_table_has_one_blank_between_columns_and_then_shorter_names) {
  EXPECT_EQ(fitted({{"b", {"ABCDEFGHIJ"}, true}, {"n", {"1000"}}}, 15),
            "b             n\nABCDEFGHIJ 1000\n");
  EXPECT_EQ(fitted({{"b", {"ABCDEFGHIJ"}, true}, {"n", {"1000"}}}, 14),
            "b            n\nABCDEFGH\xE2\x80\xA6 1000\n");
}

TEST(FittedTable, neither_numbers_nor_short_names_are_cut) {
  EXPECT_EQ(fitted({{"b", {"ABCDEFGHIJ", "short"}, true}, {"n", {"123456789", "1"}}}, 5),
            "b                n\nABCDEFG\xE2\x80\xA6 123456789\nshort            1\n");
}

TEST(FittedTable, wide_characters_count_as_two) {
  EXPECT_EQ(fitted({{"b", {"\xE9\x9B\xA8\xE9\x87\x8F", "abcd"}, true}, {"n", {"1", "2"}}}, 80),
            "b     n\n\xE9\x9B\xA8\xE9\x87\x8F  1\nabcd  2\n");
  // Five of them take ten columns: three and the ellipsis take seven, a fourth would take nine.
  const std::string five = "\xE9\x9B\xA8\xE9\x9B\xA8\xE9\x9B\xA8\xE9\x9B\xA8\xE9\x9B\xA8";
  EXPECT_EQ(fitted({{"b", {five}, true}, {"n", {"1"}}}, 8),
            "b        n\n" + five.substr(0, 9) + "\xE2\x80\xA6  1\n");
}

TEST(Wrapped, lines_break_between_words) {
  EXPECT_EQ(wrapped("one two three\nfour\n", 7), "one two\nthree\nfour\n");
  EXPECT_EQ(wrapped("one two three\nfour\n", 13), "one two three\nfour\n");
  EXPECT_EQ(wrapped("", 7), "");
}

TEST(Wrapped, a_word_that_is_too_long_has_a_line_to_itself) {
  EXPECT_EQ(wrapped("a 2020-01-01T00:00:00 b", 7), "a\n2020-01-01T00:00:00\nb\n");
}

TEST(Wrapped, wide_characters_count_as_two) {
  EXPECT_EQ(wrapped("\xE9\x9B\xA8 \xE9\x87\x8F", 4), "\xE9\x9B\xA8\n\xE9\x87\x8F\n");
}

}  // namespace
}  // namespace thiessen::cli
