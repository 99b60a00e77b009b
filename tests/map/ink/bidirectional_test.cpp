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
  for (const DirectedRun& run : directed_runs(text)) {
    line += run.right_to_left ? U"[" + run.text + U"]" : run.text;
  }
  return line;
}

// The examples of UAX 9, with Hebrew letters for its capitals.
TEST(DirectedRuns, right_to_left_words_stay_together_in_left_to_right_text) {
  EXPECT_EQ(shown(U"car is אב גד in hebrew"), U"car is [אב גד] in hebrew");
  EXPECT_EQ(shown(U"אב abc גד"), U"[ גד]abc[אב ]");
}

TEST(DirectedRuns, numbers_run_left_to_right_in_right_to_left_text) {
  EXPECT_EQ(shown(U"אב 12.5 גד"), U"[ גד]12.5[אב ]");
  EXPECT_EQ(shown(U"station אב 12"), U"station 12[אב ]");
  EXPECT_EQ(shown(U"אב ١٢"), U"١٢[אב ]");
}

TEST(DirectedRuns, plain_text_is_one_run) {
  EXPECT_EQ(directed_runs(U"Rainfall (mm), 12.5").size(), 1u);
  EXPECT_EQ(directed_runs(U"12").size(), 1u);
  EXPECT_TRUE(directed_runs(U"").empty());
}

std::u32string random_line(Seeded& seeded) {
  constexpr std::u32string_view letters = U"abאבג12٣٤ .,-(é\u0301\u05B0";
  std::u32string line;
  for (std::uint64_t i = seeded.below(16); i-- > 0;) line += letters[seeded.below(letters.size())];
  return line;
}

TEST(DirectedRuns, law_1_no_character_is_lost_or_said_twice) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(5000); ++round) {
    std::u32string line = random_line(seeded);
    std::u32string said;
    for (const DirectedRun& run : directed_runs(line)) {
      ASSERT_FALSE(run.text.empty());
      said += run.text;
    }
    std::sort(line.begin(), line.end());
    std::sort(said.begin(), said.end());
    ASSERT_TRUE(said == line);
  }
}

TEST(DirectedRuns, law_2_letters_run_their_own_way_and_digits_left_to_right) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(5000); ++round) {
    for (const DirectedRun& run : directed_runs(random_line(seeded))) {
      const auto has = [&](std::u32string_view any) {
        return run.text.find_first_of(any) != std::u32string::npos;
      };
      ASSERT_FALSE(run.right_to_left && has(U"abé12٣٤"));
      ASSERT_FALSE(!run.right_to_left && has(U"אבג"));
    }
  }
}

TEST(DirectedRuns, law_3_right_to_left_text_alone_is_one_run_and_words_in_it_stand_in_reverse) {
  EXPECT_EQ(shown(U"אבג"), U"[אבג]");
  EXPECT_EQ(shown(U"אב 1 ג 2"), U"2[ ג ]1[אב ]");
}

}  // namespace
}  // namespace thiessen
