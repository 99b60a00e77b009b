#include "text/csv_records.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

Texts records(std::string_view text, bool is_all = true) {
  Texts found;
  for (const CsvRecord& record : csv_records(text, 0, is_all)) found.emplace_back(record.text);
  return found;
}

Texts fields(std::string_view text, char separator, bool whole = true) {
  const auto found = csv_fields({text, 0, whole}, separator);
  return {found.begin(), found.end()};
}

TEST(CsvRecords, are_lines_or_hold_line_ends_in_quotes) {
  EXPECT_EQ(records("a,b\r\n\n1,2\n"), (Texts{"a,b", "1,2"}));
  EXPECT_EQ(records("a,\"b\nc\"\n1,2"), (Texts{"a,\"b\nc\"", "1,2"}));
  EXPECT_EQ(records("5\" gauges\na,b\n"), (Texts{"5\" gauges", "a,b"})) << "it never closes";
}

TEST(CsvRecords, that_the_beginning_cuts_are_not_whole) {
  EXPECT_TRUE(csv_records("a\nb", 0, true).back().whole);
  EXPECT_FALSE(csv_records("a\nb", 0, false).back().whole);
  EXPECT_EQ(fields("1,2,3", ',', false), (Texts{"1", "2"}));
}

TEST(CsvRecords, have_fields_without_quotes_and_blanks) {
  EXPECT_EQ(fields(" a , \"b,c\" ,", ','), (Texts{"a", "b,c", ""}));
  EXPECT_EQ(fields("  1   2 \"3 4\" ", ' '), (Texts{"1", "2", "3 4"}));
}

TEST(CsvRecords, tell_commas_that_may_part_thousands) {
  for (const char* number : {"1,234", "-12,500", "+999,000"})
    EXPECT_TRUE(may_part_thousands(number)) << number;
  for (const char* number :
       {"0,234", "1,23", "1,2345", "1234,567", ",234", "1,234,567", "a,234", ""})
    EXPECT_FALSE(may_part_thousands(number)) << number;
  EXPECT_EQ(no_number_for_its_comma("1,234"), " could be 1.234 or 1234");
  EXPECT_EQ(no_number_for_its_comma("1,5"), " is no number");
}

}  // namespace
}  // namespace thiessen
