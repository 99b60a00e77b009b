#include "cli/session/script_lines.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen::cli {
namespace {

using Lines = std::vector<std::string>;

void wait_for_nothing() {}

Lines lines_of(const std::string& text) {
  const TemporaryFolder folder;
  ScriptLines script(folder.write("s.txt", text));
  Lines lines;
  while (const auto line = script.next(wait_for_nothing)) {
    lines.emplace_back(*line);
    EXPECT_EQ(script.line(), lines.size());
  }
  EXPECT_FALSE(script.next(wait_for_nothing)) << "the end stays the end";
  return lines;
}

/// The complaint, from the script's name on.
std::string fault_of(const std::string& text) {
  const std::string fault = complaint_of([&] { lines_of(text); });
  return fault.substr(fault.find("s.txt"));
}

TEST(ScriptLines, end_in_lf_crlf_or_cr) {
  EXPECT_EQ(lines_of("a\nb\r\nc\rd\n"), (Lines{"a", "b", "c", "d"}));
  EXPECT_EQ(lines_of("a\n\r\n\rb"), (Lines{"a", "", "", "b"}));
  EXPECT_EQ(lines_of(""), Lines{});
  EXPECT_EQ(lines_of("\n"), Lines{""});
}

TEST(ScriptLines, skip_one_byte_order_mark_at_the_beginning) {
  EXPECT_EQ(lines_of("\xEF\xBB\xBF"
                     "a\nb"),
            (Lines{"a", "b"}));
  EXPECT_EQ(lines_of("a\n\xEF\xBB\xBF"
                     "b"),
            (Lines{"a",
                   "\xEF\xBB\xBF"
                   "b"}));
}

TEST(ScriptLines, law_1_are_the_same_wherever_the_buffer_ends) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::string text;
  Lines expected;
  while (text.size() < 400'000) {
    expected.emplace_back(random() % 300, 'x');
    if (random() % 50 == 0) expected.back() += "\xE9\x9B\xA8";
    const char* ends[] = {"\n", "\r\n", "\r"};
    text += expected.back() + ends[random() % 3];
    // A CR before an empty line that ends in LF would be one end of a line.
    if (text.back() == '\r') {
      expected.emplace_back("y");
      text += "y\n";
    }
  }
  EXPECT_TRUE(lines_of(text) == expected);
}

TEST(ScriptLines, that_are_no_text_are_told_with_line_and_byte) {
  EXPECT_EQ(fault_of(std::string("a\nb\0c\n", 6)),
            "s.txt:2: not text: NUL at byte 3 | is this a text file in UTF-8?");
  EXPECT_EQ(fault_of("a\r\nb\xFF\n"), "s.txt:2: not UTF-8 at byte 4 | save the file as UTF-8");
  EXPECT_EQ(fault_of("a\n\xE9\x9B"), "s.txt:2: not UTF-8 at byte 2 | save the file as UTF-8");
}

TEST(ScriptLines, are_of_bounded_length) {
  const std::string longest(ScriptLines::longest_line, 'x');
  EXPECT_EQ(lines_of(longest + "\na"), (Lines{longest, "a"}));
  EXPECT_EQ(fault_of("a\n" + longest + "x\n"),
            "s.txt:2: the line is longer than 65536 bytes, the limit");
  EXPECT_EQ(fault_of(std::string(1'000'000, 'x')),
            "s.txt:1: the line is longer than 65536 bytes, the limit");
}

TEST(ScriptLines, tell_before_they_wait_and_not_between_lines_that_are_there) {
  const TemporaryFolder folder;
  ScriptLines script(folder.write("s.txt", "a\nb\nc"));
  int waits = 0;
  const auto count = [&] { ++waits; };
  EXPECT_EQ(script.next(count), "a");
  EXPECT_EQ(waits, 1);
  EXPECT_EQ(script.next(count), "b");
  EXPECT_EQ(waits, 1);
  EXPECT_EQ(script.next(count), "c");
  EXPECT_EQ(waits, 2);
}

}  // namespace
}  // namespace thiessen::cli
