#include "readings/published/month_rows.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/file.h"
#include "base/temporary_folder.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

std::string header() {
  std::string text = "EstacaoCodigo,NivelConsistencia,Data";
  for (int day = 1; day <= 31; ++day)
    text += std::string(",Chuva") + (day < 10 ? "0" : "") + std::to_string(day);
  return text + "\n";
}

std::string month(const std::string& begin, const std::string& value) {
  std::string text = begin;
  for (int day = 1; day <= 31; ++day) text += "," + value;
  return text + "\n";
}

class MonthRowsTest : public testing::Test {
 protected:
  /// The days and values of all rows.
  std::vector<std::string> rows(const std::string& text) {
    MonthRows table(std::make_unique<CsvReader>(folder_.write("r.csv", header() + text)));
    std::vector<std::string> all;
    for (Row row; table.next(row);)
      all.push_back(std::string(row.fields[1]) + " " + std::string(row.fields[2]));
    return all;
  }

  const TemporaryFolder folder_;
};

TEST_F(MonthRowsTest, has_a_row_for_each_day_that_the_month_has) {
  const auto leap = rows(month("7,1,01/02/2020", "3"));
  ASSERT_EQ(leap.size(), 29U);
  EXPECT_EQ(leap.front(), "2020-02-01 3");
  EXPECT_EQ(leap.back(), "2020-02-29 3");
  EXPECT_EQ(rows(month("7,1,01/02/1900", "3")).size(), 28U);
  EXPECT_EQ(rows(month("7,1,01/12/2020 00:00:00", "3")).back(), "2020-12-31 3");
}

TEST_F(MonthRowsTest, takes_the_checked_row_of_a_month) {
  for (const bool first : {false, true}) {
    const std::string raw = month("7,1,01/04/2020", "9");
    const std::string checked = month("7,2,01/04/2020", "5");
    const auto found = rows(first ? checked + raw : raw + checked);
    EXPECT_EQ(found.size(), 30U);
    EXPECT_EQ(found.front(), "2020-04-01 5");
  }
}

TEST_F(MonthRowsTest, of_a_table_that_is_read_once_are_found_in_a_second_reader) {
  const std::string text = header() + month("7,1,01/04/2020", "9") + month("7,2,01/04/2020", "5");
  const auto once = [&] {
    return std::make_unique<CsvReader>(
        InputFile("r.csv.gz", [text, at = std::size_t{0}](std::span<char> into) mutable {
          const std::size_t count = text.copy(into.data(), into.size(), at);
          at += count;
          return count;
        }));
  };
  MonthRows table(once(), once());
  std::size_t rows = 0;
  for (Row row; table.next(row); ++rows) EXPECT_EQ(row.fields[2], "5");
  EXPECT_EQ(rows, 30U);
}

TEST_F(MonthRowsTest, days_stand_in_the_line_of_their_month) {
  const std::string file = folder_.write(
      "r.csv", header() + month("7,1,01/02/2020", "3") + "\n" + month("7,1,01/03/2020", "3"));
  MonthRows table(std::make_unique<CsvReader>(file));
  EXPECT_TRUE(table.numbers_rows());
  std::size_t last = 0;
  std::size_t rows = 0;
  for (Row row; table.next(row); last = row.line) {
    EXPECT_GT(row.line, last);
    EXPECT_EQ(table.place(row.line).line, ++rows <= 29 ? 2U : 4U);
  }
  EXPECT_EQ(rows, 60U);
}

TEST_F(MonthRowsTest, names_every_date_that_is_none) {
  const auto found =
      complaints_of([&] { rows(month("7,1,01/13/2020", "") + month("7,1,2020-01", "")); });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0],
            folder_.path() + "/r.csv:2: no date of a month such as 01/12/2020: '01/13/2020'");
}

}  // namespace
}  // namespace thiessen
