#include "base/wording.h"

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"

namespace thiessen {
namespace {

using namespace std::string_literals;

const Names spoken = {[](std::string_view name, std::string_view value) {
                        return "<" + std::string(name) + ":" + std::string(value) + ">";
                      },
                      [](std::string_view name) { return "[" + std::string(name) + "]"; }};

TEST(Wording, names_settings_and_inputs_as_its_readers_do) {
  const Wording words = "see " + setting("time_field") + " and " + setting("missing", "-99") +
                        " of " + input("stations") + "!";
  EXPECT_EQ(words.text(spoken), "see <time_field:> and <missing:-99> of [stations]!");
  EXPECT_EQ(words.plain(), "see 'time_field' and missing = -99 of 'stations'!");
}

TEST(Wording, has_a_value_of_several_words_in_quotes) {
  EXPECT_EQ(setting("time_format", "%d/%m/%Y %H:%M").plain(), "time_format = '%d/%m/%Y %H:%M'");
  EXPECT_EQ(setting("time_format", "%d/%m/%Y").plain(), "time_format = %d/%m/%Y");
}

TEST(Wording, of_text_alone_is_that_text) {
  const std::string text = "a\0b <time_field:> 'c' \x01\xFF"s;
  EXPECT_EQ(Wording(text).text(spoken), text) << "no text is taken for a name";
  EXPECT_EQ(Wording(text).plain(), text);
}

TEST(Wording, is_the_same_however_it_was_put_together) {
  Wording words = "a";
  words += "b" + setting("c");
  EXPECT_EQ(words, "ab" + setting("c"));
  EXPECT_NE(words, "ab" + input("c"));
  EXPECT_NE(words, Wording("abc"));
  words += words;
  EXPECT_EQ(words.plain(), "ab'c'ab'c'");
}

TEST(Wording, is_empty_where_nothing_is_said) {
  EXPECT_TRUE(Wording().empty());
  EXPECT_TRUE(Wording("").empty());
  EXPECT_TRUE((Wording("") + std::string()).empty());
  EXPECT_FALSE(setting("c").empty());
}

TEST(Message, placed_keeps_the_names_apart) {
  const Message message{"f", 7, "no " + setting("crs"), ""};
  EXPECT_EQ(message.placed().text(spoken), "f:7: no <crs:>");
  EXPECT_EQ(message.sentence(), "f:7: no 'crs'");
}

}  // namespace
}  // namespace thiessen
