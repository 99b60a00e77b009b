#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/seeded.h"
#include "map/ink/unicode.h"

namespace thiessen {
namespace {

/// The runs side by side, right-to-left ones in brackets.
std::u32string shown(std::u32string_view text) {
  std::u32string line;
  for (const DirectedRun& run : directed_line(text).runs) {
    line += run.right_to_left ? U"[" + run.text + U"]" : run.text;
  }
  return line;
}

// The examples of UAX 9, with Hebrew letters for its capitals.
TEST(DirectedLine, right_to_left_words_stay_together_in_left_to_right_text) {
  EXPECT_EQ(shown(U"car is אב גד in hebrew"), U"car is [אב גד] in hebrew");
  EXPECT_EQ(shown(U"אב abc גד"), U"[ גד]abc[אב ]");
}

TEST(DirectedLine, numbers_run_left_to_right_in_right_to_left_text) {
  EXPECT_EQ(shown(U"אב 12.5 גד"), U"[ גד]12.5[אב ]");
  EXPECT_EQ(shown(U"station אב 12"), U"station 12[אב ]");
  EXPECT_EQ(shown(U"אב ١٢"), U"١٢[אב ]");
}

// UAX 9: a decimal separator between Arabic digits is of the number (rule W4), brackets go with
// what they enclose (N0), and a line without letters runs left to right (P3).
TEST(DirectedLine, numbers_in_arabic_digits_stay_whole) {
  EXPECT_EQ(shown(U"١٢٫٥ مم"), U"[ مم]١٢٫٥");
  EXPECT_EQ(shown(U"١٢٫٥"), U"١٢٫٥");
  EXPECT_EQ(shown(U"Azd ١٢"), U"Azd ١٢");
}

TEST(DirectedLine, brackets_go_with_what_they_enclose) {
  EXPECT_EQ(shown(U"אב (גד) ה"), U"[אב (גד) ה]");
  EXPECT_EQ(shown(U"a (אב) c"), U"a ([אב]) c");
}

TEST(DirectedLine, has_the_direction_of_its_first_letter) {
  EXPECT_FALSE(directed_line(U"12 a אב").right_to_left);
  EXPECT_TRUE(directed_line(U"12 אב a").right_to_left);
  EXPECT_FALSE(directed_line(U"12").right_to_left);
}

TEST(ForShaper, text_whose_first_letter_tells_its_direction_stays) {
  EXPECT_EQ(for_shaper(U"abc 12", false), U"abc 12");
  EXPECT_EQ(for_shaper(U"אב (ג)", true), U"אב (ג)");
  EXPECT_EQ(for_shaper(U"12.5", false), U"12.5");
}

TEST(ForShaper, digits_that_a_shaper_would_turn_round_are_given_in_reverse) {
  EXPECT_EQ(for_shaper(U"١٢٫٥", false), U"٥٫٢١");
  EXPECT_EQ(for_shaper(U"۱۲", false), U"۲۱");
  EXPECT_EQ(for_shaper(U" (", true), U") ");
}

TEST(DirectedLine, plain_text_is_one_run) {
  EXPECT_EQ(directed_line(U"Rainfall (mm), 12.5").runs.size(), 1u);
  EXPECT_EQ(directed_line(U"12").runs.size(), 1u);
  EXPECT_TRUE(directed_line(U"").runs.empty());
}

std::u32string random_line(Seeded& seeded) {
  constexpr std::u32string_view letters = U"abאבג12٣٤ .,-(é\u0301\u05B0";
  std::u32string line;
  for (std::uint64_t i = seeded.below(16); i-- > 0;) line += letters[seeded.below(letters.size())];
  return line;
}

TEST(DirectedLine, law_1_no_character_is_lost_or_said_twice) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(5000); ++round) {
    std::u32string line = random_line(seeded);
    std::u32string said;
    for (const DirectedRun& run : directed_line(line).runs) {
      ASSERT_FALSE(run.text.empty());
      said += run.text;
    }
    std::sort(line.begin(), line.end());
    std::sort(said.begin(), said.end());
    ASSERT_TRUE(said == line);
  }
}

TEST(DirectedLine, law_2_letters_run_their_own_way_and_digits_left_to_right) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(5000); ++round) {
    for (const DirectedRun& run : directed_line(random_line(seeded)).runs) {
      const auto has = [&](std::u32string_view any) {
        return run.text.find_first_of(any) != std::u32string::npos;
      };
      ASSERT_FALSE(run.right_to_left && has(U"abé12٣٤"));
      ASSERT_FALSE(!run.right_to_left && has(U"אבג"));
    }
  }
}

TEST(DirectedLine, law_3_right_to_left_text_alone_is_one_run_and_words_in_it_stand_in_reverse) {
  EXPECT_EQ(shown(U"אבג"), U"[אבג]");
  EXPECT_EQ(shown(U"אב 1 ג 2"), U"2[ ג ]1[אב ]");
}

}  // namespace
}  // namespace thiessen
