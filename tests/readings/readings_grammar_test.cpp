#include "readings/readings_grammar.h"

#include <gtest/gtest.h>

#include <cmath>

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

/// Reads a field in both ways; that they agree is checked here.
Reading read(const std::string& field, const Texts& missing = {}, const Texts& trace = {},
             DecimalMark mark = DecimalMark::point) {
  const ReadingGrammar grammar(missing, trace, mark);
  const Reading plain = grammar.read(field, false);
  const std::string with_room = field + std::string(number_padding, '7');
  const Reading padded = grammar.read(std::string_view(with_room).substr(0, field.size()), true);
  EXPECT_EQ(padded.kind, plain.kind) << field;
  EXPECT_TRUE(padded.amount == plain.amount ||
              (std::isnan(padded.amount) && std::isnan(plain.amount)))
      << field;
  return plain;
}

ReadingKind kind(const std::string& field, const Texts& missing = {}, const Texts& trace = {}) {
  return read(field, missing, trace).kind;
}

TEST(ReadingGrammar, numbers_from_0_on_are_amounts) {
  EXPECT_EQ(read("0").amount, 0);
  EXPECT_EQ(read("12.5").amount, 12.5);
  EXPECT_EQ(read(" +1.25e1\t").amount, 12.5);
  EXPECT_EQ(kind("12.5"), ReadingKind::amount);
  EXPECT_FALSE(std::signbit(read("-0").amount));
  EXPECT_FALSE(std::signbit(read("-0.0", {"8888"}).amount));
}

TEST(ReadingGrammar, what_is_no_amount_has_no_number_that_could_be_summed) {
  for (const char* field : {"", "NA", "-1", "x", "1e400"})
    EXPECT_TRUE(std::isnan(read(field).amount));
}

TEST(ReadingGrammar, gaps_are_known_as_texts_whatever_their_case_and_as_numbers) {
  for (const char* field : {"", "  ", "na", "N/A", "nan", "NULL", "-", "-999", "-999.0", "-9.99e2",
                            "-9999", "-99.90", "\t-99.9 "})
    EXPECT_EQ(kind(field), ReadingKind::missing) << field;
  for (const char* field : {"-998", "-99", "-99.91", "-9999.5"})
    EXPECT_EQ(kind(field), ReadingKind::negative) << field;
  for (const char* field : {"NA.", "--", "none", "1 2", "1_000", "0x1"})
    EXPECT_EQ(kind(field), ReadingKind::not_a_number) << field;
}

TEST(ReadingGrammar, numbers_outside_the_range_of_doubles_are_told_apart_from_texts) {
  for (const char* field : {"1e400", "-1e400", "1e-400"})
    EXPECT_EQ(kind(field), ReadingKind::out_of_range) << field;
}

TEST(ReadingGrammar, the_users_gaps_and_traces_come_before_the_usual_ones) {
  EXPECT_EQ(kind("-"), ReadingKind::missing);
  EXPECT_EQ(read("-", {}, {"-"}).amount, 0);
  EXPECT_EQ(read("-999", {}, {"-999"}).amount, 0);
  EXPECT_EQ(kind("m", {" M "}), ReadingKind::missing);
  EXPECT_EQ(read("t", {}, {"T"}).amount, 0);
  EXPECT_EQ(kind("T", {"T"}, {"T"}), ReadingKind::missing) << "a gap before a trace";
  EXPECT_EQ(kind("NA", {"M"}, {"T"}), ReadingKind::missing) << "the usual ones stay";
}

// Numbers above 0 take the slower way through the grammar: it may find no other amounts.
TEST(ReadingGrammar, a_gap_may_be_a_number_that_rain_could_be) {
  for (const char* field : {"8888", "8888.0", "8.888e3"})
    EXPECT_EQ(kind(field, {"8888"}), ReadingKind::missing) << field;
  EXPECT_EQ(read("8888.5", {"8888"}).amount, 8888.5);
  EXPECT_EQ(kind("0", {"0"}), ReadingKind::missing);
  EXPECT_EQ(kind("-0.0", {"0"}), ReadingKind::missing);
  EXPECT_EQ(read("0.1", {"0"}).amount, 0.1);
}

TEST(ReadingGrammar, a_decimal_comma_is_read_where_told_and_then_no_point) {
  const auto with_comma = [](const std::string& field) {
    return read(field, {"-77,5", "-66.5"}, {}, DecimalMark::comma);
  };
  EXPECT_EQ(with_comma("1,5").amount, 1.5);
  EXPECT_EQ(with_comma("1.5").kind, ReadingKind::not_a_number);
  for (const char* field : {"-99,9", "-77,50", "-66,5"})
    EXPECT_EQ(with_comma(field).kind, ReadingKind::missing) << field;
}

TEST(ReadingGrammar, tells_what_a_text_may_be_meant_for) {
  const ReadingGrammar points({}, {}, DecimalMark::point);
  using Meant = ReadingGrammar::Meant;
  EXPECT_EQ(points.meant_by(" 1,5 "), Meant::decimal_comma);
  EXPECT_EQ(ReadingGrammar({}, {}, DecimalMark::comma).meant_by("4.5"), Meant::decimal_point);
  const std::string blank = "\xC2\xA0";
  for (const std::string& text :
       {std::string("1,234.5"), std::string("1.234,5"), std::string("1,234,567"),
        std::string("1 234"), std::string("1'234"), "1" + blank + "234"})
    EXPECT_EQ(points.meant_by(text), Meant::thousands) << text;
  for (const char* text : {"0.2E", "4 mm", "4*", "x7.9", "0.2T", "1,5,0", "(4)", ">100", "E0.2"})
    EXPECT_EQ(points.meant_by(text), Meant::more) << text;
  for (const char* text : {"M", "x", "<0.2", "M1", "no data", "#N/A", "--"})
    EXPECT_EQ(points.meant_by(text), Meant::code) << text;
}

}  // namespace
}  // namespace thiessen
