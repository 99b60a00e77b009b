#include "text/csv_writer.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

std::string field(std::string_view text) {
  std::string row;
  append_csv_field(row, text);
  return row;
}

TEST(CsvWriter, leaves_a_field_as_it_is_that_needs_no_quotes) {
  for (const char* text : {"", "007", "-1.5", "a b", "a;b", "a'b", "\xC3\xA9t\xC3\xA9", "=1+1"})
    EXPECT_EQ(field(text), text);
}

// RFC 4180, section 2, rules 6 and 7.
TEST(CsvWriter, quotes_a_field_that_would_end_early_and_doubles_its_quotes) {
  EXPECT_EQ(field("a,b"), "\"a,b\"");
  EXPECT_EQ(field("a\nb"), "\"a\nb\"");
  EXPECT_EQ(field("a\r"), "\"a\r\"");
  EXPECT_EQ(field("say \"x\""), "\"say \"\"x\"\"\"");
  EXPECT_EQ(field("\""), "\"\"\"\"");
}

TEST(CsvWriter, quotes_blanks_at_an_end_which_readers_take_off) {
  EXPECT_EQ(field(" a"), "\" a\"");
  EXPECT_EQ(field("a\t"), "\"a\t\"");
  EXPECT_EQ(field(" "), "\" \"");
}

TEST(CsvWriter, appends_to_what_the_row_has) {
  std::string row = "1,";
  append_csv_field(row, "a,b");
  EXPECT_EQ(row, "1,\"a,b\"");
}

TEST(CsvWriter, law_1_fields_come_back_as_they_went) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const std::vector<std::string> pieces = {",", "\"", "\n", "\r", " ", "\t", ";", "a", "\xC3\xA9"};
  std::vector<std::vector<std::string>> rows(2000, std::vector<std::string>(3));
  std::string text = "a,b,c\n";
  for (auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      for (auto n = random() % 5; n > 0; --n) row[i] += pieces[random() % pieces.size()];
      if (i > 0) text += ',';
      append_csv_field(text, row[i]);
    }
    text += '\n';
  }
  const TemporaryFolder folder;
  CsvReader reader(folder.write("f.csv", text));
  Row read;
  for (const auto& row : rows) {
    ASSERT_TRUE(reader.next(read));
    ASSERT_EQ(std::vector<std::string>(read.fields.begin(), read.fields.end()), row);
  }
  EXPECT_FALSE(reader.next(read));
}

}  // namespace
}  // namespace thiessen
