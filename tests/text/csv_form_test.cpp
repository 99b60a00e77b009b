#include "text/csv_form.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen {
namespace {

CsvForm form(std::string_view text, const CsvHints& hints = {}) {
  return find_csv_form(text, hints);
}

/// The line on which the header is found.
std::string header(std::string_view text, const CsvHints& hints = {}) {
  const std::string_view rest = text.substr(form(text, hints).header);
  return std::string(rest.substr(0, rest.find('\n')));
}

CsvHints said(char separator) {
  CsvHints hints;
  hints.separator = separator;
  return hints;
}

TEST(CsvForm, the_separator_parts_header_and_rows_alike) {
  EXPECT_EQ(form("id,x\nA,1\n").separator, ',');
  EXPECT_EQ(form("id;x;y\nA;1,5;2,5\n").separator, ';');
  EXPECT_EQ(form("a|b\n1|2\n").separator, '|');
  EXPECT_EQ(form("id\tname, of gauge, or place\n1\tA\n").separator, '\t') << "commas of a name";
  EXPECT_EQ(form("a;b,c\n").separator, ',') << "nothing below tells";
  EXPECT_EQ(form("\"a;b;c\",d\n\"e\",f\n").separator, ',') << "what stands in quotes parts nothing";
  EXPECT_EQ(form("id;x\nA;1\n", said(',')).separator, ',') << "it is said";
}

TEST(CsvForm, blanks_part_where_nothing_else_does_and_all_rows_agree) {
  EXPECT_EQ(form("id x  y\nA 1 2\nB  3 4\n").separator, ' ');
  EXPECT_EQ(form("id x  y\nA 1 2\nB  3\n").separator, ',');
  EXPECT_EQ(form("some words\nmore words\n").separator, ',') << "no known name";
}

TEST(CsvForm, empty_fields_behind_a_row_are_none) {
  EXPECT_EQ(form("When;A\n1;1,5;;\n").separator, ';');
  const std::string text = "Rain of 2020\ndate,A,B\n1,4,8,,\n2,4,8\n";
  EXPECT_EQ(header(text), "date,A,B");
  CsvHints pipe;
  pipe.one_row = true;
  pipe.is_all = false;
  EXPECT_TRUE(form("When,A\n1,4,,\n", pipe).has_rows) << "the header fits the row below it";
}

TEST(CsvForm, a_first_line_may_say_the_separator) {
  const std::string text = "sep=;\nid,x;y\nA,1;2\n";
  EXPECT_EQ(form(text).separator, ';');
  EXPECT_EQ(header(text), "id,x;y");
}

TEST(CsvForm, decimal_commas_are_found_where_nothing_contradicts) {
  EXPECT_EQ(form("id;x\nA;1,5\n").mark, DecimalMark::comma);
  EXPECT_EQ(form("id;x\nA;1,234\n").mark, DecimalMark::point) << "thousands, perhaps";
  EXPECT_EQ(form("id;x\nA;1,234\nB;1,23\n").mark, DecimalMark::comma);
  EXPECT_EQ(form("id;x;y\nA;1,5;2.5\n").mark, DecimalMark::point) << "both";
  EXPECT_EQ(form("id,x\nA,\"-0,5\"\n").mark, DecimalMark::comma);
  EXPECT_EQ(form("id;x\nA;3\n", CsvHints{'\0', true, {}, true, true, false}).mark,
            DecimalMark::comma);
}

TEST(CsvForm, remarks_before_the_header_are_passed_over) {
  EXPECT_EQ(header("# a \"quote\n#\n\nid,x\nA,1\n"), "id,x");
  EXPECT_EQ(header("# made of\n# id,x\nA,1\nB,2\n"), "id,x") << "it names the columns below";
  EXPECT_EQ(header("# id,x\nid,lon\nA,1\n"), "id,lon");
  EXPECT_EQ(form("# a\nid,x\nA,1\n").preamble, 0U);
}

TEST(CsvForm, a_header_below_a_preamble_is_found_by_its_names) {
  const std::string text = "Rain of Ore\nowner;me\n\ndate;A;B\n2020-01-01;1;2\n2020-01-02;1;2\n";
  EXPECT_EQ(header(text), "date;A;B");
  EXPECT_EQ(form(text).preamble, 3U);
  EXPECT_EQ(form(text).separator, ';');
  EXPECT_EQ(header("nothing\nknown\na,b\n1,2\n"), "nothing");
  EXPECT_EQ(header("when,A,B\n1,2,3\n"), "when,A,B") << "the first line fits the second";
  EXPECT_EQ(header("a\nb\nid,x\nA,1\n", CsvHints{'\0', false, 1, true, true, false}), "b")
      << "it is said";
}

TEST(CsvForm, a_header_that_begins_with_a_year_is_known_by_it) {
  EXPECT_EQ(form("-BEGIN HEADER-\nhours: 1, 2\n-END HEADER-\nYEAR,MO,DY,A\n2020,1,1,4\n"
                 "2020,1,2,4\n")
                .preamble,
            3U);
}

TEST(CsvForm, labels_and_their_texts_above_a_header_are_a_preamble) {
  const std::string text = "UF:;DF\nCODE:;A1\nLATITUDE:;-15,8\nData;Hora;Chuva\n2019-01-01;1;,8\n";
  EXPECT_EQ(header(text), "Data;Hora;Chuva");
  EXPECT_EQ(form(text).preamble, 3U);
  EXPECT_EQ(header("a;b\nc;d\ntime,rain,id;e\n"), "a;b") << "parted otherwise";
  EXPECT_EQ(header("a;b\nc;d\ntime;rain\n1;2\n"), "a;b") << "no more fields";
}

TEST(CsvForm, a_pipe_is_judged_by_its_first_row) {
  const CsvHints pipe{'\0', false, {}, true, false, true};
  EXPECT_FALSE(form("date;A\n2020-01-01;1", pipe).has_rows);
  EXPECT_TRUE(form("date;A\n2020-01-01;1\n", pipe).has_rows);
  EXPECT_EQ(form("date;A\n2020-01-01;1\n2020-01-02;1,5\n", pipe).mark, DecimalMark::point);
  EXPECT_FALSE(form("A title\nmore of it\n", pipe).has_rows) << "the header may yet come";
  EXPECT_EQ(header("A title\nmore of it\ndate,A\n2020,1\n", pipe), "date,A");
}

TEST(CsvForm, rows_of_units_and_of_formats_are_passed_over) {
  const CsvForm units = form(
      "date,A,B,T\n,mm,mm,\xC2\xB0"
      "C\n2020-01-01,1,2,3\n");
  EXPECT_EQ(units.rows_passed, 1U);
  EXPECT_EQ(units.units,
            "mm, \xC2\xB0"
            "C");
  EXPECT_EQ(form("date,A\nYYYY-MM-DD,[mm]\n2020-01-01,1\n").rows_passed, 1U);
  EXPECT_EQ(form("site_no\tp\n5s\t14n\n1\t2\n").rows_passed, 1U);
  EXPECT_EQ(form("id,x,y\nm,1,2\n").rows_passed, 0U) << "a gauge that is called m";
  EXPECT_EQ(form("date,A,B\n,,\n2020,1,2\n").rows_passed, 0U);
}

TEST(CsvForm, columns_at_the_end_without_a_name_and_a_value_are_passed_over) {
  EXPECT_EQ(form("date,A,,\n2020,1,,\n").columns_passed, 2U);
  EXPECT_EQ(form("date,A,,\n2020,1,5,\n").columns_passed, 1U);
  EXPECT_EQ(form("date;A;eor\n2020;1;eor\n").columns_passed, 1U);
  EXPECT_EQ(form("date;A;eor\n2020;1;2\n").columns_passed, 0U);
  EXPECT_EQ(form(",A\n2020,1\n").columns_passed, 0U) << "an index at the beginning";
}

}  // namespace
}  // namespace thiessen
