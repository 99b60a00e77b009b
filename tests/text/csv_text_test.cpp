#include "text/csv_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using Arrival = CsvText::Arrival;

/// A text in a file, read as a CSV's.
struct Opened {
  explicit Opened(const std::string& bytes) : text(InputFile(folder.write("f.csv", bytes)), ',') {}

  TemporaryFolder folder;
  CsvText text;
};

/// What is reported in the end, where nothing that was read is kept.
Arrival read_to_the_end(CsvText& text) {
  Arrival arrival = Arrival::more;
  while (arrival == Arrival::more) arrival = text.read_more(text.end());
  return arrival;
}

/// A text of some windows' length, whose characters of three bytes lie over the windows' borders.
std::string long_text(std::size_t bytes) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::string text;
  while (text.size() < bytes) text += random() % 5 == 0 ? ",\"\n\r"[random() % 4] : 'a';
  for (std::size_t at = 0; at + 3 <= text.size(); at += 4096) text.replace(at, 3, "\xE9\x9B\xA8");
  return text;
}

TEST(CsvText, gives_what_is_kept_and_what_comes) {
  const std::string whole = long_text(1'000'000);
  Opened opened(whole);
  CsvText& text = opened.text;
  EXPECT_EQ(text.size(), whole.size());
  std::size_t kept = 0;
  while (text.read_more(kept) == Arrival::more) {
    ASSERT_TRUE(text.between(kept, text.end()) == whole.substr(kept, text.end() - kept)) << kept;
    kept = text.end() - std::min<std::size_t>(text.end(), 1000);
  }
  EXPECT_EQ(text.end(), whole.size());
  EXPECT_EQ(text.at(whole.size() - 1), whole.back());
  EXPECT_EQ(text.read_more(kept), Arrival::end) << "the end stays the end";
}

TEST(CsvText, keeps_a_row_that_is_longer_than_the_window) {
  const std::string whole = long_text(2'000'000);
  Opened opened(whole);
  while (opened.text.read_more(0) == Arrival::more) {
  }
  EXPECT_TRUE(opened.text.between(0, opened.text.end()) == whole);
}

TEST(CsvText, law_1_marks_are_all_bytes_that_can_end_a_field_in_their_order) {
  const std::string whole = long_text(700'000);
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (std::string(",\"\n\r").find(whole[i]) != std::string::npos) expected.push_back(i);
  }
  Opened opened(whole);
  CsvText& text = opened.text;
  std::vector<std::size_t> found;
  for (std::size_t from = 0; text.read_more(from) == Arrival::more; from = text.end()) {
    text.seek(from);
    for (std::size_t at = text.next_mark(); at != text.end(); at = text.next_mark())
      found.push_back(at);
  }
  EXPECT_TRUE(found == expected);
}

TEST(CsvText, marks_begin_where_one_seeks) {
  Opened opened("a,b\n\"c\",d");
  ASSERT_EQ(opened.text.read_more(0), Arrival::more);
  opened.text.seek(2);
  EXPECT_EQ(opened.text.next_mark(), 3U);
  opened.text.seek(1);
  EXPECT_EQ(opened.text.next_mark(), 1U);
  opened.text.seek(8);
  EXPECT_EQ(opened.text.next_mark(), opened.text.end()) << "bytes past the text are none of it";
}

TEST(CsvText, names_the_place_of_the_first_byte_that_is_no_text) {
  const std::string before = long_text(600'000);
  const struct {
    std::string tail;
    Arrival arrival;
    std::size_t place;
  } cases[] = {{std::string("1\0\xFF", 3), Arrival::nul, 1},
               {std::string("12\xFF\0", 4), Arrival::not_utf8, 2},
               {"\xC0\xAF", Arrival::not_utf8, 0},
               {"ab\xE9\x9B", Arrival::not_utf8, 2}};  // the end cuts the last character
  for (const auto& bad : cases) {
    Opened opened(before + bad.tail);
    EXPECT_EQ(read_to_the_end(opened.text), bad.arrival);
    EXPECT_EQ(opened.text.fault(), before.size() + bad.place);
  }
}

TEST(CsvText, of_an_empty_file_is_at_its_end) {
  Opened opened("");
  EXPECT_EQ(opened.text.read_more(0), Arrival::end);
  EXPECT_EQ(opened.text.end(), 0U);
}

}  // namespace
}  // namespace thiessen
