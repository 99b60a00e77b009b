#include "base/error.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen {
namespace {

using namespace std::string_literals;

TEST(Message, names_file_and_line_before_the_text) {
  EXPECT_EQ((Message{"a.csv", 17, "is odd", "do this"}.sentence()), "a.csv:17: is odd");
  EXPECT_EQ((Message{"a.csv", 0, "is odd", ""}.sentence()), "a.csv: is odd");
  EXPECT_EQ((Message{"", 0, "a.csv exists already", ""}.sentence()), "a.csv exists already");
}

TEST(Message, stays_on_one_line_and_sends_nothing_to_the_terminal) {
  const Message message{"a\nb.csv", 1, "station '\x1b[2J' is odd", ""};
  EXPECT_EQ(message.sentence(), "a\\x0ab.csv:1: station '\\x1b[2J' is odd");
}

TEST(Printable, keeps_every_script_of_the_world) {
  const std::string text = "สถานี 经度 Zürich 🌧 ~";
  EXPECT_EQ(printable(text), text);
}

TEST(Printable, shows_control_characters_by_their_numbers) {
  EXPECT_EQ(printable("a\0b"s), "a\\x00b");
  EXPECT_EQ(printable("\t\x7f"), "\\x09\\x7f");
  EXPECT_EQ(printable("\xC2\x9B"), "\\u009b");      // CSI, in one character
  EXPECT_EQ(printable("\xE2\x80\xAE"), "\\u202e");  // right-to-left override
  EXPECT_EQ(printable("\xE2\x80\xA8"), "\\u2028");  // line separator
}

TEST(Printable, shows_bytes_that_are_not_utf8) {
  EXPECT_EQ(printable("Z\xFCrich"), "Z\\xfcrich");
  EXPECT_EQ(printable("\xE4\xB8"), "\\xe4\\xb8");
}

TEST(Error, says_all_of_its_messages) {
  const Error error({{"f", 1, "one", ""}, {"f", 2, "two", ""}}, 3);
  EXPECT_STREQ(error.what(), "f:1: one\nf:2: two\nand 3 more");
  EXPECT_EQ(error.messages().size(), 2u);
  EXPECT_EQ(error.unlisted(), 3u);
}

Complaints complaints_on_lines(std::size_t first, std::size_t last) {
  Complaints complaints;
  for (std::size_t line = first; line <= last; ++line) complaints.add({"f", line, "bad", ""});
  return complaints;
}

TEST(Complaints, list_the_first_20_and_count_the_rest) {
  Complaints complaints = complaints_on_lines(1, 25);
  try {
    complaints.throw_if_any();
    FAIL();
  } catch (const Error& error) {
    ASSERT_EQ(error.messages().size(), 20u);
    EXPECT_EQ(error.messages().back().line, 20u);
    EXPECT_EQ(error.unlisted(), 5u);
  }
  EXPECT_NO_THROW(complaints.throw_if_any()) << "they are thrown once";
}

TEST(Complaints, are_silent_where_there_are_none) {
  EXPECT_NO_THROW(Complaints().throw_if_any());
}

TEST(Complaints, found_in_any_order_list_the_first_by_line) {
  Complaints complaints;
  for (std::size_t i = 0; i < 101; ++i) {  // 37 i mod 101 takes every value once
    complaints.add_by_line({"f", 37 * i % 101 + 1, "wrong", ""});
  }
  try {
    complaints.throw_if_any();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.unlisted(), 81u);
    ASSERT_EQ(error.messages().size(), 20u);
    for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(error.messages()[i].line, i + 1);
  }
}

TEST(Complaints, merge_in_the_order_of_the_lines) {
  Complaints complaints = complaints_on_lines(10, 25);
  complaints.add(complaints_on_lines(1, 30));  // of which 10 are only counted
  try {
    complaints.fail({"f", 12, "no further", ""});
  } catch (const Error& error) {
    ASSERT_EQ(error.messages().size(), 20u);
    EXPECT_EQ(error.messages().front().line, 1u);
    EXPECT_EQ(error.messages()[10].line, 10u);
    EXPECT_EQ(error.messages()[11].line, 11u);
    EXPECT_EQ(error.messages().size() + error.unlisted(), 16u + 30u + 1u);
  }
}

TEST(Complaints, the_reason_why_reading_stopped_is_listed_behind_any_number_of_others) {
  Complaints complaints;
  for (std::size_t line = 1; line <= 25; ++line) complaints.add({"f", line, "bad", ""});
  try {
    complaints.fail({"f", 26, "no further", ""});
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    ASSERT_EQ(error.messages().size(), Complaints::listed_at_most);
    EXPECT_EQ(error.messages().back().sentence(), "f:26: no further");
    EXPECT_EQ(error.messages().size() + error.unlisted(), 26U);
  }
}

}  // namespace
}  // namespace thiessen
