#include "gdal/layers/sheet_table.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "gdal/drivers.h"
#include "gdal/layers/xlsx_file.h"

namespace thiessen {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// A sheet, read.
struct Read {
  explicit Read(const std::string& rows, std::optional<std::size_t> skip = {},
                const std::string& workbook = "") {
    start_gdal();
    const TemporaryFolder folder;
    const std::string path = folder.path("r.xlsx");
    write_xlsx(path, {{"rain", rows}}, workbook);
    SheetTable table({path, path, "", "rainfall_layer", skip}, &warnings);
    header = table.header();
    header_line = table.header_line();
    for (Row row; table.next(row);) {
      this->rows.emplace_back(row.fields.begin(), row.fields.end());
      lines.push_back(row.line);
    }
  }

  std::vector<std::string> header;
  std::size_t header_line = 0;
  Rows rows;
  std::vector<std::size_t> lines;
  Warnings warnings;
};

std::string row(int number, const std::string& cells) {
  return "<row r=\"" + std::to_string(number) + "\">" + cells + "</row>";
}

const std::string header = row(1, "<c r=\"A1\" t=\"s\"><v>0</v></c><c r=\"B1\"><v>7</v></c>");

TEST(SheetTable, keeps_the_clock_whatever_the_form_of_the_cell) {
  const Read read(header + row(2, "<c s=\"1\"><v>43831</v></c><c><v>1.5</v></c>") +
                  row(3, "<c s=\"1\"><v>43831.25</v></c><c><v>2</v></c>"));
  EXPECT_EQ(read.header, (std::vector<std::string>{"time", "7"})) << "an id that is a number";
  EXPECT_EQ(read.rows, (Rows{{"2020-01-01T00:00", "1.5"}, {"2020-01-01T06:00", "2"}}));
}

TEST(SheetTable, has_dates_where_no_cell_has_a_clock) {
  EXPECT_EQ(Read(header + row(2, "<c s=\"1\"><v>43831</v></c>")).rows, (Rows{{"2020-01-01", ""}}));
  EXPECT_EQ(Read(header + row(2, "<c s=\"2\"><v>43831</v></c>")).rows,
            (Rows{{"2020-01-01T00:00", ""}}));
  EXPECT_EQ(
      Read(header + row(2, "<c s=\"1\"><v>42369</v></c>"), {}, "<workbookPr date1904=\"1\"/>").rows,
      (Rows{{"2020-01-01", ""}}));
}

TEST(SheetTable, numbers_rows_as_the_sheet_does_and_passes_empty_ones_over) {
  const Read read(row(3,
                      "<c r=\"A3\" t=\"inlineStr\"><is><t>date</t></is></c><c r=\"B3\" "
                      "t=\"s\"><v>1</v></c>") +
                  row(4, "<c r=\"A4\" s=\"1\"/>") +
                  row(7, "<c r=\"A7\" t=\"str\"><v>2020-01-01</v></c><c r=\"B7\"><v>3.0</v></c>"));
  EXPECT_EQ(read.header, (std::vector<std::string>{"date", "A"}));
  EXPECT_EQ(read.header_line, 3U);
  EXPECT_EQ(read.rows, (Rows{{"2020-01-01", "3"}}));
  EXPECT_EQ(read.lines, (std::vector<std::size_t>{7}));
  EXPECT_TRUE(read.warnings.notices().empty());
}

TEST(SheetTable, passes_titles_above_the_header_over_and_says_so) {
  const std::string title = row(1, "<c r=\"A1\" t=\"inlineStr\"><is><t>Rain of 2020</t></is></c>");
  const std::string names =
      row(3, "<c r=\"A3\" t=\"s\"><v>0</v></c><c r=\"B3\" t=\"s\"><v>1</v></c>");
  const std::string data = row(4, "<c r=\"A4\" s=\"1\"><v>43831</v></c><c r=\"B4\"><v>5</v></c>");
  const Read read(title + names + data);
  EXPECT_EQ(read.header, (std::vector<std::string>{"time", "A"}));
  EXPECT_EQ(read.rows, (Rows{{"2020-01-01", "5"}}));
  ASSERT_EQ(read.warnings.notices().size(), 1U);
  EXPECT_TRUE(contains(read.warnings.notices()[0].sentence(),
                       "its header stands in row 3, below a row that is passed over"));
  EXPECT_EQ(Read(title + names + data, 2).header_line, 3U);
}

TEST(SheetTable, passes_a_row_of_units_over_and_has_them) {
  start_gdal();
  const TemporaryFolder folder;
  const std::string path = folder.path("r.xlsx");
  const std::string unit = "<c r=\"B2\" t=\"inlineStr\"><is><t>[in]</t></is></c>";
  const std::string data = row(3, "<c r=\"A3\" s=\"1\"><v>43831</v></c><c r=\"B3\"><v>5</v></c>");
  write_xlsx(path, {{"rain", header + row(2, unit) + data}});
  Warnings warnings;
  SheetTable table({path, path, "", "rainfall_layer", {}}, &warnings);
  EXPECT_EQ(table.unit(0), "");
  EXPECT_EQ(table.unit(1), "in");
  Row first;
  ASSERT_TRUE(table.next(first));
  EXPECT_EQ(first.line, 3U);
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_TRUE(contains(warnings.notices()[0].sentence(),
                       "below its header a row of units ([in]) is passed over"));
  EXPECT_EQ(table.again()->unit(1), "in");
}

TEST(SheetTable, takes_na_for_nothing_and_other_errors_and_formulas_for_what_they_are) {
  const Read read(header + row(2, "<c s=\"1\"><v>43831</v></c><c t=\"e\"><v>#N/A</v></c>") +
                  row(3, "<c s=\"1\"><v>43832</v></c><c t=\"e\"><v>#DIV/0!</v></c>") +
                  row(4, "<c s=\"1\"><v>43833</v></c><c><f>B2*2</f></c>") +
                  row(5, "<c s=\"1\"><v>43834</v></c><c><f>B2*2</f><v>0.1</v></c>"));
  EXPECT_EQ(read.rows, (Rows{{"2020-01-01", ""},
                             {"2020-01-02", "#DIV/0!"},
                             {"2020-01-03", "="},
                             {"2020-01-04", "0.1"}}));
}

TEST(SheetTable, refuses_what_is_broken) {
  EXPECT_TRUE(contains(complaint_of([] { Read(header + "<row"); }), "is not whole"));
  EXPECT_TRUE(contains(complaint_of([] { Read(header + row(2, "<c t=\"s\"><v>9</v></c>")); }),
                       "r.xlsx:2: a cell names a text that the file lacks"));
  EXPECT_TRUE(contains(
      complaint_of([] { Read(header + row(2, "<c><v>1</v></c><c><v>2</v></c><c><v>3</v></c>")); }),
      "r.xlsx:2: has 3 cells, and the header 2"));
  EXPECT_TRUE(contains(complaint_of([] { Read(""); }), "has no sheet with a cell"));
}

TEST(SheetTable, is_the_sheet_that_is_named_or_the_only_one_with_a_cell) {
  start_gdal();
  const TemporaryFolder folder;
  const std::string path = folder.path("r.xlsx");
  const std::string notes = row(1, "<c t=\"s\"><v>1</v></c>");
  write_xlsx(path, {{"notes", notes}, {"empty", ""}, {"rain", header}});
  const auto open = [&](const std::string& layer) {
    return SheetTable({path, path, layer, "rainfall_layer", {}}, nullptr).header();
  };
  EXPECT_EQ(open("rain"), (std::vector<std::string>{"time", "7"}));
  EXPECT_TRUE(contains(complaint_of([&] { open(""); }), "has several layers: 'notes', 'rain'"));
  EXPECT_TRUE(contains(complaint_of([&] { open("rains"); }), "has no layer 'rains'"));
  write_xlsx(path, {{"empty", ""}, {"rain", header}});
  EXPECT_EQ(open(""), (std::vector<std::string>{"time", "7"}));
}

}  // namespace
}  // namespace thiessen
