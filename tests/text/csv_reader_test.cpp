#include "text/csv_reader.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/fed_pipe.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using namespace std::literals;
using Fields = std::vector<std::string>;

/// What a reader makes of a text: the header first, then the rows with their lines, then the error.
struct Outcome {
  Fields header;
  std::vector<Fields> rows;
  std::vector<std::size_t> lines;
  std::vector<std::string> sentences;
  std::vector<std::string> hints;
  std::size_t unlisted = 0;
};

Outcome read(const std::string& text, CsvOptions options = {}) {
  const TemporaryFolder folder;
  const std::string path = folder.write("f.csv", text);
  Outcome outcome;
  try {
    CsvReader reader(path, options);
    outcome.header = reader.header();
    for (Row row; reader.next(row);) {
      outcome.rows.emplace_back(row.fields.begin(), row.fields.end());
      outcome.lines.push_back(row.line);
    }
  } catch (const Error& error) {
    for (const Message& message : error.messages()) {
      EXPECT_EQ(message.file, path);
      outcome.sentences.push_back(message.sentence().substr(path.size() - 5));
      outcome.hints.push_back(message.hint.plain());
    }
    outcome.unlisted = error.unlisted();
  }
  return outcome;
}

void expect_rows(const std::string& text, const std::vector<Fields>& rows,
                 const std::vector<std::size_t>& lines) {
  const Outcome outcome = read(text);
  EXPECT_EQ(outcome.sentences, Fields{}) << text;
  EXPECT_EQ(outcome.rows, rows) << text;
  EXPECT_EQ(outcome.lines, lines) << text;
}

void expect_error(const std::string& text, const std::string& sentence) {
  EXPECT_EQ(read(text).sentences, Fields{sentence}) << text;
}

TEST(CsvReader, reads_lines_however_they_end) {
  const std::vector<Fields> rows = {{"1", "2"}, {"3", "4"}};
  expect_rows("a,b\n1,2\n3,4\n", rows, {2, 3});
  expect_rows("a,b\r\n1,2\r\n3,4\r\n", rows, {2, 3});
  expect_rows("a,b\r1,2\r3,4\r", rows, {2, 3});
  expect_rows("a,b\n1,2\r3,4", rows, {2, 3});
  expect_rows("\xEF\xBB\xBF\"a\",b\n1,2\n3,4", rows, {2, 3});
}

TEST(CsvReader, passes_over_blank_lines_and_counts_them) {
  expect_rows("\n\na,b\n\r\n1,2\n  \t\n\n3,4\n\n", {{"1", "2"}, {"3", "4"}}, {5, 8});
  expect_rows("a,b\n1,2\n   ", {{"1", "2"}}, {2});
  expect_rows("a\n\n1\n", {{"1"}}, {3});
}

TEST(CsvReader, takes_quotes_by_rfc_4180) {
  expect_rows("a,b\n\"1,5\",\"say \"\"x\"\"\"\n", {{"1,5", "say \"x\""}}, {2});
  expect_rows("a,b\n\"\",\"\"\"\"\n", {{"", "\""}}, {2});
  expect_rows("a,b\n\"x\ny\r\nz\rw\",2\n3,\"4\"", {{"x\ny\r\nz\rw", "2"}, {"3", "4"}}, {2, 6});
  expect_rows("a,b\r\n\"1\",\"2\"\r\n\"3\",\"4\"\r\n", {{"1", "2"}, {"3", "4"}}, {2, 3});
  expect_rows("a,b\n\" 1\t\", 2 \n", {{" 1\t", " 2 "}}, {2});
  expect_rows("a\n\"\"\n", {{""}}, {2});
}

TEST(CsvReader, keeps_empty_fields) {
  expect_rows("a,b,c\n,,\n1,,\n", {{"", "", ""}, {"1", "", ""}}, {2, 3});
}

TEST(CsvReader, trims_header_names_outside_quotes) {
  EXPECT_EQ(read(" time , A\t,\" B \",\n").header, (Fields{"time", "A", " B ", ""}));
}

TEST(CsvReader, takes_a_header_without_rows) {
  expect_rows("a,b", {}, {});
  expect_rows("a,b\n", {}, {});
}

TEST(CsvReader, refuses_an_empty_file) {
  for (const std::string text : {"", "\n", "\r\n\n  \n", "\xEF\xBB\xBF", "\xEF\xBB\xBF\n"}) {
    expect_error(text, "f.csv: is empty");
  }
}

TEST(CsvReader, refuses_two_byte_order_marks) {
  expect_error(
      "\xEF\xBB\xBF\xEF\xBB\xBF"
      "a,b\n",
      "f.csv:1: begins with two byte order marks");
}

TEST(CsvReader, gathers_rows_of_another_length) {
  const Outcome outcome = read("a,b\n1\n1,2\n1,2,3\n1,2,\n\"\"\n");
  EXPECT_EQ(outcome.sentences, (Fields{"f.csv:2: row has 1 field, the header has 2",
                                       "f.csv:4: row has 3 fields, the header has 2",
                                       "f.csv:5: row has 3 fields, the header has 2",
                                       "f.csv:6: row has 1 field, the header has 2"}));
  EXPECT_EQ(outcome.rows, (std::vector<Fields>{{"1", "2"}}));
}

TEST(CsvReader, lists_twenty_bad_rows_and_counts_the_others) {
  std::string text = "a,b\n";
  for (int i = 0; i < 100'000; ++i) text += "1\n";
  const Outcome outcome = read(text);
  ASSERT_EQ(outcome.sentences.size(), 20u);
  EXPECT_EQ(outcome.sentences.back(), "f.csv:21: row has 1 field, the header has 2");
  EXPECT_EQ(outcome.unlisted, 99'980u);
}

TEST(CsvReader, gathers_quotes_out_of_place) {
  const Outcome outcome = read("a,b\n1,2\"3\"\n\"1\"2,3\n4, \"5\"\n\"6\n\"7,8\n9,10\n");
  EXPECT_EQ(outcome.sentences, (Fields{"f.csv:2: a quote stands inside field 2",
                                       "f.csv:3: text follows the closing quote of field 1",
                                       "f.csv:4: a quote stands inside field 2",
                                       "f.csv:6: text follows the closing quote of field 1"}));
  EXPECT_EQ(outcome.rows, (std::vector<Fields>{{"9", "10"}}));
  EXPECT_EQ(outcome.lines, (std::vector<std::size_t>{7}));
}

TEST(CsvReader, names_the_line_where_an_unclosed_quote_opened) {
  expect_error("a,b\n1,2\n3,\"4\n5,6\n", "f.csv:3: the quote that opens here is never closed");
  expect_error("a,\"b\n5,6\n", "f.csv:1: the quote that opens here is never closed");
  expect_error("a,b\n\"x\ny\",\"z", "f.csv:3: the quote that opens here is never closed");
  expect_error("a,b\n1,\"2\"\"", "f.csv:2: the quote that opens here is never closed");
}

TEST(CsvReader, reports_earlier_bad_rows_beside_what_ends_the_reading) {
  EXPECT_EQ(read("a,b\n1\n3,\"4\n").sentences,
            (Fields{"f.csv:2: row has 1 field, the header has 2",
                    "f.csv:3: the quote that opens here is never closed"}));
}

TEST(CsvReader, names_the_byte_of_a_nul) {
  expect_error("a,b\n1,2\n3\0,4\n"s, "f.csv:3: not text: NUL at byte 9");
  expect_error("a\0"s, "f.csv:1: not text: NUL at byte 1");
}

TEST(CsvReader, names_the_byte_that_is_not_utf8) {
  expect_error("a,b\n1,Z\xFCrich\n", "f.csv:2: not UTF-8 at byte 7");
  expect_error("a,b\n1,\xC0\xAF\n", "f.csv:2: not UTF-8 at byte 6");
  expect_error("a,b\n1,\xED\xA0\x80\n", "f.csv:2: not UTF-8 at byte 6");
  expect_error("a,b\n1,\xE4\xB8", "f.csv:2: not UTF-8 at byte 6");
  CsvOptions found;
  found.finds_form = true;
  EXPECT_EQ(read("a,b\n1,\xC0\n", found).hints,
            Fields{"'encoding' names what it is, such as Latin-1 or cp932"});
  found.input = "rainfall";
  EXPECT_EQ(read("a,b\n1,\xC0\n", found).hints,
            Fields{"'rainfall_encoding' names what it is, such as Latin-1 or cp932"});
}

TEST(CsvReader, refuses_names_that_stand_twice_but_for_none) {
  EXPECT_EQ(read("a,b,a,\"a\"\n").sentences,
            (Fields{"f.csv:1: the header has 'a' twice, in columns 1 and 3",
                    "f.csv:1: the header has 'a' twice, in columns 1 and 4"}));
  EXPECT_EQ(read("a,,A,\n").header, (Fields{"a", "", "A", ""}));
}

TEST(CsvReader, takes_the_separator_that_is_given) {
  const Outcome semicolons = read("time;A;B\n1;2,5;3\n");
  EXPECT_EQ(semicolons.sentences, Fields{"f.csv:1: the header is one field, 'time;A;B'"});
  EXPECT_EQ(semicolons.hints, Fields{"without 'separator' each file's own is found out: comma, "
                                     "semicolon, tab or bar"});
  EXPECT_EQ(read("time,A\n", {';', {}}).hints, semicolons.hints);
  EXPECT_EQ(read("time;A;B\n1;2,5;3\n", {';', {}}).rows, (std::vector<Fields>{{"1", "2,5", "3"}}));
  EXPECT_EQ(read("time\tA\n\t\n1\t2\n", {'\t', {}}).rows,
            (std::vector<Fields>{{"", ""}, {"1", "2"}}));
}

TEST(CsvReader, finds_out_what_parts_the_fields) {
  const std::vector<Fields> rows{{"1", "2"}};
  for (const char c : {',', ';', '\t', '|'}) {
    const std::string parting(1, c);
    EXPECT_EQ(read("a" + parting + "b\n1" + parting + "2\n", {'\0', {}}).rows, rows) << c;
    EXPECT_EQ(read("\r\n\n\"a,;|\"" + parting + "b\n1" + parting + "2", {'\0', {}}).rows, rows)
        << c;
  }
  EXPECT_EQ(read("a,b;c\n1,2\n", {'\0', {}}).rows, rows);
  EXPECT_EQ(read("a;b;c, local\n1;2;3\n", {'\0', {}}).rows, (std::vector<Fields>{{"1", "2", "3"}}));
  EXPECT_EQ(read("a\n1;2\n", {'\0', {}}).rows, (std::vector<Fields>{{"1;2"}}));
  EXPECT_EQ(read("a", {'\0', {}}).header, Fields{"a"});
  EXPECT_EQ(read("", {'\0', {}}).sentences, Fields{"f.csv: is empty"});
}

TEST(CsvReader, bounds_a_field) {
  CsvOptions options;
  options.limits.field_bytes = 10;
  EXPECT_EQ(read("a,b\n1,0123456789\n", options).rows, (std::vector<Fields>{{"1", "0123456789"}}));
  EXPECT_EQ(read("a,b\n1,01234567890\n", options).sentences,
            Fields{"f.csv:2: field 2 is longer than 10 bytes, the limit"});
  EXPECT_EQ(read("a,b\n1,\"01234567890\"\n", options).sentences,
            Fields{"f.csv:2: field 2 is longer than 10 bytes, the limit"});
  EXPECT_EQ(read("a,b\n1," + std::string(1'100'000, 'x') + "\n").sentences,
            Fields{"f.csv:2: field 2 is longer than 1048576 bytes, the limit"});
  EXPECT_EQ(
      read("a,b\n1,\"" + std::string(9'000'000, '\n')).sentences,
      Fields{"f.csv:2: the quote that opens here is not closed within 1048576 bytes, the limit "
             "for a field"});
}

TEST(CsvReader, bounds_a_row_and_its_columns) {
  CsvOptions options;
  options.limits.row_bytes = 1'000'000;
  options.limits.columns = 1000;
  std::string long_row = "1";
  for (int i = 0; i < 600'000; ++i) long_row += ",1";
  EXPECT_EQ(read("a,b\n" + long_row + "\n", options).sentences,
            Fields{"f.csv:2: the row is longer than 1000000 bytes, the limit"});
  EXPECT_EQ(read(long_row + "\n", options).sentences,
            Fields{"f.csv:1: has more than 1000 columns, the limit"});
}

TEST(CsvReader, knows_how_much_is_read) {
  const TemporaryFolder folder;
  CsvReader reader(folder.write("f.csv", "a,b\n1,2\n3,4444\n"));  // 15 bytes
  EXPECT_EQ(reader.share_read(), 4.0 / 15);
  Row row;
  EXPECT_TRUE(reader.next(row));
  EXPECT_EQ(reader.share_read(), 8.0 / 15);
  EXPECT_TRUE(reader.next(row));
  EXPECT_EQ(reader.share_read(), 1);
}

TEST(CsvReader, does_not_know_how_much_is_read_of_what_has_no_size) {
  EXPECT_TRUE(std::isnan(CsvReader("/proc/mounts", {.has_names = false}).share_read()));
}

TEST(CsvReader, ends_on_devices_that_never_do) {
  EXPECT_THROW(CsvReader("/dev/zero"), Error);
  EXPECT_THROW(CsvReader("/dev/null"), Error);
}

/// The grammar once more, a character at a time, for well-formed texts without blank lines.
std::vector<Fields> parse_slowly(const std::string& text) {
  std::vector<Fields> rows(1, Fields(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quoted && text[i] == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      rows.back().back() += text[++i];
    } else if (text[i] == '"') {
      quoted = !quoted;
    } else if (!quoted && text[i] == ',') {
      rows.back().emplace_back();
    } else if (!quoted && text[i] == '\n') {
      rows.emplace_back(1);
    } else {
      rows.back().back() += text[i];
    }
  }
  rows.pop_back();
  return rows;
}

std::string random_field(std::mt19937& random) {
  constexpr std::string_view plain = "01.x\xC3\xBC";
  constexpr std::string_view odd[] = {",", "\n", "\"\"", "\r\n", "\xE4\xB8\x96", "y"};
  std::string field;
  const bool quoted = random() % 4 == 0;
  for (std::size_t n = random() % (random() % 50 == 0 ? 300 : 8); n > 0; --n) {
    if (quoted) {
      field += odd[random() % std::size(odd)];
    } else {
      field += plain.substr(0, 4)[random() % 4];
    }
  }
  return quoted ? "\"" + field + "\"" : field;
}

TEST(CsvReader, agrees_with_a_slow_parser_across_the_edges_of_its_window) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (const std::size_t columns : {std::size_t{2}, std::size_t{7}, std::size_t{100'000}}) {
    std::string text;
    for (std::size_t i = 0; i < columns; ++i) text += (i > 0 ? ",c" : "c") + std::to_string(i);
    text += '\n';
    while (text.size() < 3'000'000) {
      for (std::size_t i = 0; i < columns; ++i) text += (i > 0 ? "," : "") + random_field(random);
      text += '\n';
    }
    std::vector<Fields> expected = parse_slowly(text);
    const Outcome outcome = read(text);
    ASSERT_EQ(outcome.sentences, Fields{});
    ASSERT_EQ(outcome.header, expected[0]);
    expected.erase(expected.begin());
    ASSERT_TRUE(outcome.rows == expected) << columns << " columns";
  }
}

TEST(CsvReader, survives_every_damage_to_a_small_file) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const std::string whole = "time,\"A \"\"1\"\"\",B\r\n\"x\ny\",1.5,\n2,,\"\xC3\xBC\"\n";
  constexpr std::string_view bytes = "\"\n\r,;\0\xFF\xC3x "sv;
  for (int i = 0; i < 1000; ++i) {
    std::string text = whole.substr(0, random() % (whole.size() + 1));
    for (std::size_t n = random() % 4; n > 0 && !text.empty(); --n) {
      text[random() % text.size()] = bytes[random() % bytes.size()];
    }
    const Outcome outcome = read(text);
    for (const Fields& row : outcome.rows) ASSERT_EQ(row.size(), outcome.header.size());
  }
}

CsvOptions finding(char separator = '\0') {
  CsvOptions options;
  options.separator = separator;
  options.finds_form = true;
  return options;
}

TEST(CsvReader, passes_over_what_stands_round_a_table) {
  const Outcome outcome = read(
      "# remark\nTitle\n\ndate;A; B ;;eor\n;mm;mm;;\n 2020 ; 1;\"2 \";;eor\n;;;;\n3;4;5;;\n;;;;\n",
      finding());
  EXPECT_EQ(outcome.sentences, Fields{});
  EXPECT_EQ(outcome.header, (Fields{"date", "A", "B"}));
  EXPECT_EQ(outcome.rows, (std::vector<Fields>{{"2020", "1", "2 "}, {"3", "4", "5"}}));
  EXPECT_EQ(outcome.lines, (std::vector<std::size_t>{6, 8}));
}

TEST(CsvReader, passes_empty_fields_behind_the_last_column_over) {
  const Outcome outcome = read("date,A,B\n1,4,8,,\n2,5,6\n3,7,,,,eor\n", finding());
  EXPECT_EQ(outcome.sentences, Fields{});
  EXPECT_EQ(outcome.header, (Fields{"date", "A", "B"}));
  EXPECT_EQ(outcome.rows, (std::vector<Fields>{{"1", "4", "8"}, {"2", "5", "6"}, {"3", "7", ""}}));
  EXPECT_EQ(read("date,A,B,\n1,4,8,, , \n", finding()).rows, (std::vector<Fields>{{"1", "4", "8"}}))
      << "blanks are none, and the header may have one, too";
  EXPECT_EQ(read("date,A,B\n1,4,8,,\n2,4,8,9\n3,4,8,,9\n", finding()).sentences,
            (Fields{"f.csv:3: row has 4 fields, the header has 3",
                    "f.csv:4: row has 5 fields, the header has 3"}));
}

TEST(CsvReader, has_blanks_for_one_separator) {
  const Outcome outcome = read("id  x y\n A 1   2\nB \"3 4\" 5 \n", finding());
  EXPECT_EQ(outcome.header, (Fields{"id", "x", "y"}));
  EXPECT_EQ(outcome.rows, (std::vector<Fields>{{"A", "1", "2"}, {"B", "3 4", "5"}}));
}

TEST(CsvReader, complains_of_a_value_in_a_column_that_was_passed_over) {
  std::string text = "date,A,\n";
  for (int i = 0; i < 20'000; ++i) text += std::to_string(i) + ",1,\n";  // beyond the first 64 kB
  EXPECT_EQ(
      read(text + "x,1,2\n", finding()).sentences,
      Fields{"f.csv:20002: a value stands in column 3, which has no name and no values in the "
             "rows above"});
}

TEST(CsvReader, reads_other_encodings) {
  CsvOptions latin = finding();
  latin.encoding = "Latin-1";
  EXPECT_EQ(read("id,x\nZ\xFCrich,1\n", latin).rows, (std::vector<Fields>{{"Z\xC3\xBCrich", "1"}}));
  EXPECT_EQ(read("\xFE\xFF\0i\0d\0\n\0A\0\n"s).rows, (std::vector<Fields>{{"A"}}));
  CsvOptions japanese;
  japanese.encoding = "cp932";
  EXPECT_EQ(read("id\n\x89\x4A\n\x81\xFF\n", japanese).sentences,
            Fields{"f.csv:3: not cp932 at byte 6"});
}

TEST(CsvReader, numbers_the_columns_of_a_table_without_a_header) {
  CsvOptions options = finding();
  options.numbers = {"1", "3"};
  const Outcome outcome = read("13/02/2010;A;0,5\n14/02/2010;A;1\n", options);
  EXPECT_EQ(outcome.header, (Fields{"1", "2", "3"}));
  EXPECT_EQ(outcome.rows,
            (std::vector<Fields>{{"13/02/2010", "A", "0,5"}, {"14/02/2010", "A", "1"}}));
  EXPECT_EQ(outcome.lines, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(read("1,2,3\n4,5,6\n", options).rows.size(), 2U) << "1, 2 and 3 are data";
  EXPECT_EQ(read("3,x,1\n4,5,6\n", options).header, (Fields{"3", "x", "1"})) << "names";
}

TEST(CsvReader, finds_its_form_again) {
  const TemporaryFolder folder;
  CsvReader reader(folder.write("f.csv", "Title\nid;x\nA;1,5\n"), finding());
  EXPECT_EQ(reader.decimal_mark(), DecimalMark::comma);
  EXPECT_EQ(reader.header_line(), 2U);
  EXPECT_EQ(reader.again()->header(), reader.header());
  EXPECT_EQ(reader.again()->decimal_mark(), DecimalMark::comma);
}

// A pipe brings half a row, the rest, lines that are no rows, and one with a fault.
TEST(CsvReader, knows_whether_a_row_of_a_pipe_has_come) {
  using std::chrono::milliseconds;
  FedPipe pipe;
  pipe.feed("a,b\n1,2\n3");
  CsvReader reader(pipe.path());
  Row row;
  EXPECT_FALSE(reader.is_waiting(milliseconds(0)));
  EXPECT_FALSE(reader.is_waiting(milliseconds(0)));
  ASSERT_TRUE(reader.next(row));
  EXPECT_EQ(row.fields[1], "2");
  EXPECT_TRUE(reader.is_waiting(milliseconds(1)));
  pipe.feed(",4\r\n\n \n\"5\n\",6\n");
  EXPECT_FALSE(reader.is_waiting(milliseconds(0)));
  ASSERT_TRUE(reader.next(row));
  EXPECT_EQ(row.fields[0], "3");
  EXPECT_EQ(row.line, 3U);
  EXPECT_FALSE(reader.is_waiting(milliseconds(0)));
  ASSERT_TRUE(reader.next(row));
  EXPECT_EQ(row.fields[0], "5\n");
  EXPECT_EQ(row.line, 6U);
  pipe.feed("7\n8,9\n");
  EXPECT_FALSE(reader.is_waiting(milliseconds(0)));
  EXPECT_EQ(complaint_of([&] { reader.next(row); }),
            pipe.path() + ":8: row has 1 field, the header has 2");
}

TEST(CsvReader, never_waits_for_a_file) {
  const TemporaryFolder folder;
  CsvReader reader(folder.write("x.csv", "a,b\n1,2"));
  EXPECT_FALSE(reader.is_waiting(std::chrono::milliseconds(0)));
}

}  // namespace
}  // namespace thiessen
