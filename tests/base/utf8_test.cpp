#include "base/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen {
namespace {

TEST(Utf8, takes_the_first_and_last_character_of_each_length) {
  for (const std::string text : {"\x01\x7F", "\xC2\x80\xDF\xBF", "\xE0\xA0\x80\xEF\xBF\xBF",
                                 "\xF0\x90\x80\x80\xF4\x8F\xBF\xBF", "\xED\x9F\xBF\xEE\x80\x80"}) {
    EXPECT_EQ(find_invalid_utf8(text), std::nullopt) << text;
  }
}

TEST(Utf8, refuses_overlong_forms_surrogates_and_what_lies_beyond_unicode) {
  for (const std::string bad :
       {"\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF", "\xED\xA0\x80", "\xED\xBF\xBF",
        "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xFE", "\x80", "\xC3(", "\xE4\xB8("}) {
    EXPECT_EQ(find_invalid_utf8("ab" + bad), 2u) << "bytes of length " << bad.size();
  }
}

TEST(Utf8, finds_the_byte_wherever_it_stands) {
  for (std::size_t length = 0; length < 200; ++length) {
    const std::string text = std::string(length, 'a') + "\xFC" + std::string(100, 'b');
    EXPECT_EQ(find_invalid_utf8(text), length);
  }
}

TEST(Utf8, tells_a_character_cut_off_from_a_wrong_one) {
  const Utf8Prefix cut = valid_utf8_prefix("ab\xF0\x9F\x8C");
  EXPECT_EQ(cut.valid, 2u);
  EXPECT_TRUE(cut.truncated);
  EXPECT_FALSE(valid_utf8_prefix("ab\xF0\x80").truncated) << "no character begins so";
  EXPECT_EQ(find_invalid_utf8("ab\xF0\x9F\x8C"), 2u);
}

TEST(Text, compares_without_the_case_of_ascii_letters) {
  EXPECT_TRUE(equal_ignoring_case("Station_ID", "sTATION_id"));
  EXPECT_FALSE(equal_ignoring_case("station", "stations"));
  EXPECT_FALSE(equal_ignoring_case("[", "{"))
      << "they differ in the bit that makes a letter's case";
  EXPECT_EQ(lower_case("AZ[]Ü"), "az[]Ü");
}

TEST(Text, loses_blanks_at_its_ends_only) {
  EXPECT_EQ(trimmed(" \ta b\t "), "a b");
  EXPECT_EQ(trimmed("  "), "");
}

TEST(Text, is_cut_between_characters) {
  EXPECT_EQ(quoted("abc"), "'abc'");
  EXPECT_EQ(quoted("a\xC3\xBC\xC3\xBC", 4), "'a\xC3\xBC...'");
}

}  // namespace
}  // namespace thiessen
