#include "map/opencv/typesetter.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

namespace thiessen {
namespace {

bool has_ink(const SetText& text) {
  return std::accumulate(text.ink.values.begin(), text.ink.values.end(), 0) > 0;
}

TEST(Typesetter, text_is_cut_to_its_ink) {
  Typesetter type;
  const SetText text = type.set("H", 40);
  ASSERT_TRUE(has_ink(text));
  // DejaVu Sans: capitals are 1493 / 2048 em high and stand on the baseline.
  EXPECT_NEAR(text.height(), 40 * 1493 / 2048.0, 2);
  EXPECT_EQ(text.baseline, text.height());
  for (const int x : {0, text.width() - 1}) {
    int column = 0;
    for (int y = 0; y < text.height(); ++y) column += text.ink.at(x, y);
    EXPECT_GT(column, 0);
  }
}

TEST(Typesetter, fitted_text_keeps_within_its_width) {
  Typesetter type;
  const std::string title = "Mean areal precipitation of the upper basin, water year 1988 to 1997";
  for (const int width : {5, 40, 120, 300, 700, 2000}) {
    EXPECT_LE(type.fit(title, 32, 16, width, Weight::bold).width(), width);
  }
  EXPECT_EQ(type.fit(title, 20, 12, 2000).width(), type.set(title, 20).width());
}

TEST(Typesetter, nothing_to_set_has_no_ink) {
  Typesetter type;
  EXPECT_EQ(type.set("", 20).width(), 0);
  EXPECT_EQ(type.set(" \n\t ", 20).width(), 0);
  EXPECT_TRUE(type.missing().empty());
}

TEST(Typesetter, what_no_font_has_is_told_and_stands_as_a_sign) {
  Typesetter type;
  const SetText text = type.set("a\U0010F123", 20);  // for private use
  EXPECT_GT(text.width(), type.set("a", 20).width());
  EXPECT_EQ(type.missing(), U"\U0010F123");
  type.set("\U0010F124 \U0010F123\U0010F122", 20);
  EXPECT_EQ(type.missing(), U"\U0010F123\U0010F124\U0010F122") << "as they come";
}

TEST(Typesetter, hostile_text_is_set_or_left_out_but_never_fails) {
  Typesetter type;
  EXPECT_NO_THROW(type.set(std::string(5000, 'x'), 20));
  std::string marks = "e";
  for (int i = 0; i < 300; ++i) marks += "\u0301";
  EXPECT_NO_THROW(type.set(marks, 20));
  EXPECT_NO_THROW(type.set("\xFF\xFE\x00 \xF0\x9F", 20));
  EXPECT_NO_THROW(type.set("\U0001F327 \U0001F468\u200D\U0001F469", 20));
  EXPECT_LT(type.set(std::string(5000, 'x'), 20, Weight::regular, 24).width(), 24 * 20);
}

TEST(Typesetter, ligatures_and_shaped_scripts_are_drawn) {
  Typesetter type;
  EXPECT_TRUE(has_ink(type.set("difficult office", 24)));
  EXPECT_TRUE(has_ink(type.set("محطة الأمطار ١٢", 24)));
  // In words joined to one another the letters differ from letters standing alone.
  const int joined = type.set("ببب", 60).width();
  const int alone = type.set("ب ب ب", 60).width();
  EXPECT_LT(joined, alone);
}

bool is_same_ink(const SetText& a, const SetText& b) {
  return a.ink.width == b.ink.width && a.ink.values == b.ink.values;
}

// What stands at the left end of a number is its first digit, in any digits.
TEST(Typesetter, arabic_digits_run_from_left_to_right) {
  Typesetter type;
  const SetText number = type.set("١٢٫٥", 40);
  const SetText first = type.set("١", 40);
  const SetText last = type.set("٥", 40);
  ASSERT_TRUE(has_ink(first));
  const auto column = [](const SetText& text, int x) {
    int sum = 0;
    for (int y = 0; y < text.height(); ++y) sum += text.ink.at(x, y);
    return sum;
  };
  for (int x = 0; x < first.width(); ++x) EXPECT_EQ(column(number, x), column(first, x)) << x;
  for (int x = 1; x <= last.width(); ++x)
    EXPECT_EQ(column(number, number.width() - x), column(last, last.width() - x)) << x;
  EXPECT_FALSE(number.right_to_left);
  EXPECT_TRUE(type.set("١٢٫٥ مم", 40).right_to_left);
}

// A letter and its mark look like the letter that has it.
TEST(Typesetter, combining_marks_stand_on_their_letters) {
  Typesetter type;
  EXPECT_TRUE(is_same_ink(type.set("e\u0301", 40), type.set("\u00E9", 40)));
  EXPECT_TRUE(is_same_ink(type.set("Z\u030C", 40), type.set("\u017D", 40)));
  EXPECT_EQ(type.set("x\u0301", 40).width(), type.set("x", 40).width());
}

TEST(Typesetter, keeps_what_is_said_in_reading_order) {
  Typesetter type;
  const SetText text = type.set("  אב abc\n", 20, Weight::bold);
  EXPECT_EQ(text.text, "אב abc");
  EXPECT_EQ(text.size, 20);
  EXPECT_EQ(text.weight, Weight::bold);
}

TEST(Typesetter, tells_of_letters_drawn_from_bitmaps) {
  Typesetter type;
  type.set("Rainfall Łódź محطة", 20);
  EXPECT_TRUE(type.coarse().empty());
}

}  // namespace
}  // namespace thiessen
