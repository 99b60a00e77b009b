#include "text/text_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/complaints.h"
#include "base/file.h"

namespace thiessen {
namespace {

/// A text that comes in pieces of a size.
InputFile in_pieces(std::string text, std::size_t size) {
  return {"a.txt",
          [text = std::move(text), size, at = std::size_t{0}](std::span<char> into) mutable {
            const std::size_t count = std::min({size, into.size(), text.size() - at});
            std::copy_n(text.begin() + static_cast<std::ptrdiff_t>(at), count, into.begin());
            at += count;
            return count;
          }};
}

std::vector<std::string> lines_of(const std::string& text, std::size_t size) {
  TextLines lines(in_pieces(text, size));
  std::vector<std::string> all;
  while (const auto line = lines.next()) all.emplace_back(*line);
  EXPECT_EQ(lines.line(), all.size());
  return all;
}

TEST(TextLines, are_the_same_in_pieces_of_any_size) {
  const std::string text =
      "\xEF\xBB\xBF"
      "a\r\n\nbc\nlast";
  for (const std::size_t size : {1U, 2U, 3U, 100U})
    EXPECT_EQ(lines_of(text, size), (std::vector<std::string>{"a", "", "bc", "last"})) << size;
  EXPECT_EQ(lines_of("x\n", 1), std::vector<std::string>{"x"});
  EXPECT_TRUE(lines_of("", 1).empty());
}

TEST(TextLines, an_endless_line_is_an_error) {
  EXPECT_EQ(
      complaint_of([] { lines_of(std::string(TextLines::longest_line + 100'000, 'x'), 65536); }),
      "a.txt:1: the line is longer than 1048576 bytes");
}

TEST(TakeLine, takes_the_lines_of_a_text_in_their_order_without_their_ends) {
  std::string_view text = "a\r\n\nb\rc\nlast";
  EXPECT_EQ(take_line(text), "a");
  EXPECT_EQ(text, "\nb\rc\nlast");
  EXPECT_EQ(take_line(text), "");
  EXPECT_EQ(take_line(text), "b\rc") << "a return alone ends no line";
  EXPECT_EQ(take_line(text), "last");
  EXPECT_EQ(take_line(text), "") << "nothing is left";
}

TEST(TakeLine, leaves_nothing_behind_the_end_of_the_last_line) {
  for (std::string_view text : {"a", "a\n", "a\r\n", "a\r"}) {
    EXPECT_EQ(take_line(text), "a");
    EXPECT_TRUE(text.empty());
  }
}

TEST(TakeLine, takes_the_lines_that_are_read_of_a_file) {
  const std::string text = "\r\na\r\n\n b \nlast\r";
  std::vector<std::string> taken;
  for (std::string_view rest = text; !rest.empty();) taken.emplace_back(take_line(rest));
  EXPECT_EQ(taken, lines_of(text, 3));
}

}  // namespace
}  // namespace thiessen
