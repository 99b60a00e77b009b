#include "map/ink/unicode.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(Unicode, bytes_that_are_not_utf8_become_replacement_characters) {
  EXPECT_EQ(displayable("a\xFFz"), U"a\uFFFDz");
  EXPECT_EQ(displayable("\xC0\xAF"), U"\uFFFD\uFFFD") << "overlong";
  EXPECT_EQ(displayable("\xED\xA0\x80"), U"\uFFFD\uFFFD\uFFFD") << "surrogate";
  EXPECT_EQ(displayable("\xF4\x90\x80\x80"), U"\uFFFD\uFFFD\uFFFD\uFFFD") << "above U+10FFFF";
  EXPECT_EQ(displayable("\xE9\x99"), U"\uFFFD\uFFFD") << "cut off";
}

TEST(Unicode, text_of_any_plane_survives_both_ways) {
  const std::string text = "m\u00b2 \u0e1d\u0e19 \u96e8 \U0001D50A";
  EXPECT_EQ(to_utf8(displayable(text)), text);
}

TEST(Unicode, controls_become_spaces_and_overrides_vanish) {
  EXPECT_EQ(displayable("a\nb\tc\x1b[2J"), U"a b c [2J");
  EXPECT_EQ(displayable("safe\u202Egnp"), U"safegnp");
}

TEST(Unicode, long_texts_are_cut_before_a_letter) {
  EXPECT_EQ(shortened(U"abc", 3), U"abc");
  EXPECT_EQ(shortened(U"abcd", 3), U"abc…");
  EXPECT_EQ(shortened(U"abe\u0301d", 3), U"ab…");
  EXPECT_EQ(shortened(U"ab cd", 3), U"ab…");
}

/// The runs side by side, right-to-left ones in brackets.
std::u32string shown(std::u32string_view text) {
  std::u32string line;
  for (const DirectedRun& run : directed_runs(text)) {
    line += run.right_to_left ? U"[" + run.text + U"]" : run.text;
  }
  return line;
}

// The examples of UAX 9, with Hebrew letters for its capitals.
TEST(Unicode, right_to_left_words_stay_together_in_left_to_right_text) {
  EXPECT_EQ(shown(U"car is אב גד in hebrew"), U"car is [אב גד] in hebrew");
  EXPECT_EQ(shown(U"אב abc גד"), U"[ גד]abc[אב ]");
}

TEST(Unicode, numbers_run_left_to_right_in_right_to_left_text) {
  EXPECT_EQ(shown(U"אב 12.5 גד"), U"[ גד]12.5[אב ]");
  EXPECT_EQ(shown(U"station אב 12"), U"station 12[אב ]");
  EXPECT_EQ(shown(U"אב ١٢"), U"١٢[אב ]");
}

TEST(Unicode, plain_text_is_one_run) {
  EXPECT_EQ(directed_runs(U"Rainfall (mm), 12.5").size(), 1u);
  EXPECT_EQ(directed_runs(U"12").size(), 1u);
  EXPECT_TRUE(directed_runs(U"").empty());
}

}  // namespace
}  // namespace thiessen
