#include "map/opencv/fonts.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

namespace thiessen {
namespace {

TEST(Fonts, latin_text_is_set_in_the_preferred_font) {
  const FontList fonts(false);
  EXPECT_EQ(fonts.first_to_cover(U"Rainfall (mm) é"), 0u);
}

TEST(Fonts, the_first_font_that_has_all_characters_is_chosen) {
  const FontList fonts(false);
  for (const std::u32string text : {U"Київ", U"Ἀθῆναι", U"ปริมาณน้ำฝน", U"降雨量", U"محطة", U"a降"}) {
    const auto chosen = fonts.first_to_cover(text);
    for (std::size_t font = 0; font < fonts.size(); ++font) {
      const bool covers = fonts.covers(font, text);
      if (chosen && font > *chosen) break;
      EXPECT_EQ(covers, chosen && font == *chosen);
    }
  }
}

TEST(Fonts, invisible_characters_need_no_glyph) {
  const FontList fonts(false);
  EXPECT_EQ(fonts.first_to_cover(U"a\u200Db\uFE0F"), 0u);
}

TEST(Fonts, are_files_of_this_machine_in_either_weight) {
  for (const bool bold : {false, true}) {
    const FontList fonts(bold);
    ASSERT_GT(fonts.size(), 0u);
    for (std::size_t font = 0; font < fonts.size(); ++font)
      EXPECT_TRUE(std::filesystem::is_regular_file(fonts.face(font).file)) << fonts.face(font).file;
  }
  EXPECT_NE(FontList(false).face(0).file, FontList(true).face(0).file);
}

TEST(Fonts, law_1_come_in_one_order_whenever_they_are_asked_for) {
  const FontList once(false);
  const FontList again(false);
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t font = 0; font < once.size(); ++font) {
    EXPECT_EQ(once.face(font).file, again.face(font).file);
    EXPECT_EQ(once.face(font).face, again.face(font).face);
  }
}

TEST(Fonts, law_2_lists_made_at_once_leave_the_signals_as_they_were) {
  when_fonts_break_off([]() noexcept { std::_Exit(1); });
  const auto make_some = [] {
    for (int i = 0; i < 8; ++i) const FontList fonts(false);
  };
  struct sigaction before = {};
  ::sigaction(SIGSEGV, nullptr, &before);
  std::thread other(make_some);
  make_some();
  other.join();
  when_fonts_break_off(nullptr);
  struct sigaction after = {};
  ::sigaction(SIGSEGV, nullptr, &after);
  EXPECT_EQ(after.sa_handler, before.sa_handler);
  ::sigaction(SIGSEGV, &before, nullptr);
}

TEST(Fonts, none_covers_a_character_for_private_use) {
  EXPECT_EQ(FontList(false).first_to_cover(U"\U0010F123"), std::nullopt);
  EXPECT_EQ(FontList(false).first_to_cover(U""), 0u) << "nothing needs no glyph";
}

TEST(Fonts, those_of_bitmaps_come_last) {
  const FontList fonts(false);
  bool pixels = false;
  for (std::size_t font = 0; font < fonts.size(); ++font) {
    EXPECT_TRUE(fonts.has_pixels(font) || !pixels) << fonts.face(font).file;
    pixels = fonts.has_pixels(font);
    EXPECT_EQ(pixels, fonts.face(font).file.find("unifont") != std::string::npos);
  }
}

}  // namespace
}  // namespace thiessen
