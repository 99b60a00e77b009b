#include "gdal/layers/ods_rows.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "gdal/drivers.h"
#include "gdal/layers/ods_file.h"
#include "gdal/layers/sheet_table.h"

namespace thiessen {
namespace {

using Rows = std::vector<std::vector<std::string>>;
using Lines = std::vector<std::size_t>;

std::string row(const std::string& cells, const std::string& attributes = "") {
  return "<table:table-row" + attributes + ">" + cells + "</table:table-row>";
}

std::string text(const std::string& words) {
  return "<table:table-cell office:value-type=\"string\"><text:p>" + words +
         "</text:p></table:table-cell>";
}

std::string number(const std::string& value) {
  return "<table:table-cell office:value-type=\"float\" office:value=\"" + value +
         "\"><text:p>shown</text:p></table:table-cell>";
}

std::string date(const std::string& value) {
  return "<table:table-cell office:value-type=\"date\" office:date-value=\"" + value + "\"/>";
}

const std::string nothing = "<table:table-cell/>";
const std::string header = row(text("time") + text("a"));

/// A sheet, read as a table.
struct Read {
  explicit Read(const std::string& rows_written, std::optional<std::size_t> skip = {}) {
    start_gdal();
    const TemporaryFolder folder;
    const std::string path = folder.path("r.ods");
    write_ods(path, {{"rain", rows_written}});
    SheetTable table({path, path, "", "rainfall_layer", skip, SheetKind::ods}, &warnings);
    header = table.header();
    header_line = table.header_line();
    for (std::size_t i = 0; i < header.size(); ++i) units.push_back(table.unit(i));
    above = table.lines_above();
    for (Row row; table.next(row);) {
      rows.emplace_back(row.fields.begin(), row.fields.end());
      lines.push_back(row.line);
    }
  }

  std::vector<std::string> header, units, above;
  std::size_t header_line = 0;
  Rows rows;
  Lines lines;
  Warnings warnings;
};

TEST(OdsRows, have_times_and_numbers_whatever_their_cells_show) {
  const Read read(header + row(date("2020-01-01") + number("1.50")) +
                  row(date("2020-01-01T05:59:59.999999997") + number("1e-1")));
  EXPECT_EQ(read.header, (std::vector<std::string>{"time", "a"}));
  EXPECT_EQ(read.rows, (Rows{{"2020-01-01T00:00", "1.5"}, {"2020-01-01T06:00", "0.1"}}))
      << "a midnight among clocks has one";
  EXPECT_EQ(Read(header + row(date("2020-01-01") + number("2"))).rows, (Rows{{"2020-01-01", "2"}}));
  EXPECT_EQ(Read(header + row("<table:table-cell office:value-type=\"time\" "
                              "office:time-value=\"PT06H30M00S\"/>" +
                              number("2")))
                .rows,
            (Rows{{"06:30", "2"}}));
}

TEST(OdsRows, have_the_texts_of_cells_without_remarks) {
  const std::string remark =
      "<table:table-cell office:value-type=\"string\"><office:annotation><text:p>a "
      "remark</text:p></office:annotation><text:p>a<text:s text:c=\"2\"/>b</text:p><text:p>"
      "<text:span>c</text:span></text:p></table:table-cell>";
  const std::string truth =
      "<table:table-cell office:value-type=\"boolean\" office:boolean-value=\"true\"/>";
  const std::string formula = "<table:table-cell table:formula=\"of:=[.A1]\"/>";
  const Read read(header + row(remark + truth) + row(text("#N/A") + text("#DIV/0!")) +
                  row(text("x") + formula));
  EXPECT_EQ(read.rows, (Rows{{"a  b\nc", "1"}, {"", "#DIV/0!"}, {"x", "="}}));
}

TEST(OdsRows, that_are_repeated_come_as_often) {
  const std::string twice =
      "<table:table-cell table:number-columns-repeated=\"2\" "
      "office:value-type=\"float\" office:value=\"7\"/>";
  const std::string blanks = "<table:table-cell table:number-columns-repeated=\"16000\"/>";
  const std::string empty_rows = " table:number-rows-repeated=\"3\"";
  const Read read(row(nothing, empty_rows) + row(text("id") + text("x") + text("y") + blanks) +
                  row(text("a") + twice + blanks) + row(blanks, empty_rows) +
                  row(text("b") + nothing + number("1"), " table:number-rows-repeated=\"2\"") +
                  row(blanks, " table:number-rows-repeated=\"1048000\""));
  EXPECT_EQ(read.header_line, 4U);
  EXPECT_EQ(read.rows, (Rows{{"a", "7", "7"}, {"b", "", "1"}, {"b", "", "1"}}));
  EXPECT_EQ(read.lines, (Lines{5, 9, 10}));
}

TEST(OdsRows, below_a_title_and_a_row_of_units_are_those_of_the_table) {
  const std::string title = row(text("Rain of 2020, in") + text("inches"));
  const std::string data = row(date("2020-01-01") + number("5"));
  const Read read(title + row(nothing) + header + row(nothing + text("in")) + data);
  EXPECT_EQ(read.header, (std::vector<std::string>{"time", "a"}));
  EXPECT_EQ(read.units, (std::vector<std::string>{"", "in"}));
  EXPECT_EQ(read.above, (std::vector<std::string>{"Rain of 2020, in,inches"}));
  EXPECT_EQ(read.rows, (Rows{{"2020-01-01", "5"}}));
  ASSERT_EQ(read.warnings.notices().size(), 2U);
  EXPECT_TRUE(contains(read.warnings.notices()[0].sentence(),
                       "its header stands in row 3, below a row that is passed over"));
  EXPECT_TRUE(contains(read.warnings.notices()[1].sentence(),
                       "below its header a row of units (in) is passed over"));
  EXPECT_EQ(Read(title + header + data, 1).header_line, 2U);
}

TEST(OdsRows, are_those_of_the_sheet_that_is_named_or_the_only_one_with_a_cell) {
  start_gdal();
  const TemporaryFolder folder;
  const std::string path = folder.path("r.ods");
  write_ods(path, {{"notes", row(text("x"))}, {"empty", row(nothing)}, {"rain", header}});
  EXPECT_EQ(ods_sheets(path, "/vsizip/{" + path + "}/content.xml"),
            (std::vector<std::string>{"notes", "empty", "rain"}));
  const auto open = [&](const std::string& layer) {
    return SheetTable({path, path, layer, "rainfall_layer", {}, SheetKind::ods}, nullptr).header();
  };
  EXPECT_EQ(open("rain"), (std::vector<std::string>{"time", "a"}));
  EXPECT_TRUE(contains(complaint_of([&] { open(""); }), "has several layers: 'notes', 'rain'"));
}

TEST(OdsRows, refuse_what_is_broken_or_endless) {
  EXPECT_TRUE(contains(complaint_of([] { Read(header + "<table:table-row"); }), "is not whole"));
  EXPECT_TRUE(contains(complaint_of([] {
                         Read(header +
                              row("<table:table-cell table:number-columns-repeated=\"99999999\" "
                                  "office:value-type=\"float\" office:value=\"7\"/>"));
                       }),
                       "r.ods:2: a cell stands in no column"));
  EXPECT_TRUE(contains(
      complaint_of([] { Read(row(nothing, " table:number-rows-repeated=\"1048576\"") + header); }),
      "a row stands beyond the sheet's end"));
}

}  // namespace
}  // namespace thiessen
