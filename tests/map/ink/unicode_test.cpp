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

}  // namespace
}  // namespace thiessen
