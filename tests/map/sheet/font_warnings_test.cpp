// Linked with OpenCV: texts are set.
#include "map/sheet/font_warnings.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"

namespace thiessen {
namespace {

Warnings warnings_of(const Typesetter& type) {
  Warnings warnings;
  warn_of_fonts(type, warnings);
  return warnings;
}

TEST(FontWarnings, are_none_of_what_is_shown) {
  Typesetter type;
  type.set("Rainfall (mm) é", 20);
  EXPECT_TRUE(warnings_of(type).messages().empty());
  EXPECT_TRUE(warnings_of(type).notices().empty());
}

// For private use, which no font shows.
TEST(FontWarnings, name_characters_that_no_font_shows_and_packages_of_fonts) {
  Typesetter type;
  type.set("a\U0010F123\U0010F123", 20);
  const Warnings warnings = warnings_of(type);
  ASSERT_EQ(warnings.messages().size(), 1U);
  EXPECT_EQ(warnings.messages()[0].sentence(),
            "no installed font shows 1 of the picture's characters, such as \U0010F123");
  EXPECT_TRUE(contains(warnings.messages()[0].hint.plain(), "fonts-noto-core"));
}

TEST(FontWarnings, name_five_of_many_and_how_many_there_are) {
  Typesetter type;
  type.set("\U0010F127\U0010F126\U0010F125\U0010F124\U0010F123\U0010F122\U0010F121", 20);
  EXPECT_EQ(
      sentences_of(warnings_of(type)),
      std::vector<std::string>{"no installed font shows 7 of the picture's characters, such as "
                               "\U0010F127, \U0010F126, \U0010F125, \U0010F124, \U0010F123"});
}

/// The notice of characters of bitmaps, with its hint; empty where an installed font has outlines.
std::string notice_of(const std::string& text) {
  Typesetter type;
  type.set(text, 20);
  const Warnings warnings = warnings_of(type);
  if (type.coarse().empty()) {
    EXPECT_TRUE(warnings.notices().empty());
    return {};
  }
  EXPECT_EQ(warnings.notices().size(), 1U);
  const Message& notice = warnings.notices().at(0);
  return notice.sentence() + " | " + notice.hint.plain();
}

// The name of a country, with vowel signs and a virama, and a letter that comes twice.
TEST(FontWarnings, of_bitmaps_quote_words_as_they_are_written) {
  const std::string notice = notice_of("ଓଡ଼ିଶା ବର୍ଷା ଓଡ଼ିଶା");
  if (notice.empty()) GTEST_SKIP() << "the fonts of this machine have outlines";
  EXPECT_TRUE(contains(notice, "words, such as ଓଡ଼ିଶା, ବର୍ଷା, are drawn")) << notice;
}

TEST(FontWarnings, of_bitmaps_name_the_package_of_a_better_font) {
  const std::string east_asian = notice_of("雨");
  const std::string other = notice_of("ଵ");
  const std::string before = "some of the picture's words, such as ";
  const std::string after =
      ", are drawn from bitmaps, whose letters do not join | install a font with their outlines: ";
  if (east_asian.empty() && other.empty())
    GTEST_SKIP() << "the fonts of this machine have outlines of both";
  if (!east_asian.empty()) {
    EXPECT_EQ(east_asian, before + "雨" + after + "fonts-noto-cjk");
  }
  if (!other.empty()) {
    EXPECT_EQ(other, before + "ଵ" + after + "fonts-noto-core");
  }
  if (!east_asian.empty() && !other.empty()) {
    EXPECT_EQ(notice_of("雨 ଵ"), before + "雨, ଵ" + after + "fonts-noto-cjk and fonts-noto-core");
  }
}

}  // namespace
}  // namespace thiessen
