#include "readings/published/swat_steps.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <span>

#include "base/file.h"

namespace thiessen {
namespace {

using Values = std::vector<std::string>;

std::vector<int> clocks_of(const std::string& text) {
  TextLines lines(InputFile("p.pcp", [text, at = std::size_t{0}](std::span<char> into) mutable {
    const std::size_t count = text.copy(into.data(), into.size(), at);
    at += count;
    return count;
  }));
  return swat_clocks(lines);
}

TEST(SwatSteps, have_a_clock_behind_the_date) {
  EXPECT_EQ(swat_clock("200005900:00001.0"), 0);
  EXPECT_EQ(swat_clock("2000059 6:30001.0"), 390);
  EXPECT_EQ(swat_clock("200005923:59001.0"), 1439);
  EXPECT_EQ(swat_clock("200005924:00001.0"), std::nullopt);
  EXPECT_EQ(swat_clock("200005912:60001.0"), std::nullopt);
  EXPECT_EQ(swat_clock("2000059000.5012.0"), std::nullopt) << "a day of two gauges";
  EXPECT_EQ(swat_clock("200005900:00"), std::nullopt) << "no value";
}

TEST(SwatSteps, a_dry_day_has_blanks_for_its_clock) {
  EXPECT_TRUE(is_dry_day_of_swat("2000059     000.0"));
  EXPECT_FALSE(is_dry_day_of_swat("200005900:00000.0"));
  EXPECT_FALSE(is_dry_day_of_swat("2000059  0.5"));
}

TEST(SwatSteps, of_a_day_are_those_of_the_first_that_has_any) {
  EXPECT_EQ(clocks_of("2000058     000.0\n200005900:00001.0\n200005912:00002.0\n"
                      "200006000:00001.0\n"),
            (std::vector<int>{0, 720}));
  EXPECT_EQ(clocks_of("2000059000.5\n2000060000.5\n"), std::vector<int>{});
  EXPECT_EQ(clocks_of(""), std::vector<int>{});
}

TEST(SwatSteps, law_1_the_length_of_a_line_tells_the_width_of_its_values) {
  EXPECT_EQ(swat_values_of_step("200005900:00001.0 12.5", 2), (Values{"001.0", "12.5"}));
  EXPECT_EQ(swat_values_of_step("200005900:00  1.00 12.50  ", 2), (Values{"1.00", "12.50"}));
  EXPECT_EQ(swat_values_of_step("200005900:00001.0", 2), Values{});
  EXPECT_EQ(swat_values_of_step("200005900:00001.0", 0), Values{});
}

}  // namespace
}  // namespace thiessen
