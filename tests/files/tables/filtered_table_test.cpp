#include "files/tables/filtered_table.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

/// The first fields of the rows that a filter keeps of a CSV.
Texts kept(const std::string& text, const std::string& where, Warnings& warnings) {
  const TemporaryFolder folder;
  const auto table = keep_rows(std::make_unique<CsvReader>(folder.write("r.csv", text)),
                               {where, "rainfall_where"}, {}, warnings);
  Texts found;
  for (Row row; table->next(row);) found.emplace_back(row.fields[0]);
  return found;
}

Texts kept(const std::string& text, const std::string& where) {
  Warnings warnings;
  return kept(text, where, warnings);
}

TEST(FilteredTable, keeps_the_rows_that_meet_the_filter) {
  const std::string by_year = "id,element,value\nA,PRCP,1\nA,TMAX,280\nB,PRCP,3\n";
  EXPECT_EQ(kept(by_year, "ELEMENT = 'PRCP'"), (Texts{"A", "B"})) << "names whatever their case";
  EXPECT_EQ(kept(by_year, "element = 'TMAX' OR id = 'B'"), (Texts{"A", "B"}));
}

TEST(FilteredTable, compares_as_numbers_where_the_beginning_holds_numbers_alone) {
  EXPECT_EQ(kept("id,value\nA,9\nB,10\nC, 200\nD,\n", "value > 9.5"), (Texts{"B", "C"}));
  EXPECT_EQ(kept("id,value\nA,9\nB,10\nC,T\n", "value > '5'"), (Texts{"A", "C"}))
      << "as texts, of which '10' comes before '5'";
}

TEST(FilteredTable, refuses_a_text_among_numbers_behind_the_beginning) {
  std::string rows = "id,value\n";
  for (int i = 0; i < 20'000; ++i) rows += "A,1\n";  // 80,000 bytes
  EXPECT_EQ(kept(rows + "B,T\n", "id = 'B'"), (Texts{"B"})) << "a field that it does not ask";
  EXPECT_TRUE(contains(complaint_of([&] { kept(rows + "B,T\n", "value > 2"); }),
                       "r.csv:20002: 'T' is no number, and 'rainfall_where' compares 'value'"));
}

TEST(FilteredTable, warns_where_no_row_is_kept) {
  Warnings warnings;
  EXPECT_EQ(kept("id,value\nA,9\nB,10\n", "id = 'C'", warnings), Texts());
  ASSERT_EQ(warnings.messages().size(), 1U);
  EXPECT_TRUE(contains(warnings.messages()[0].sentence(),
                       "none of its 2 rows meets rainfall_where = 'id = 'C''"));
}

TEST(FilteredTable, is_filtered_alike_when_it_is_opened_again) {
  const TemporaryFolder folder;
  Warnings warnings;
  const auto table =
      keep_rows(std::make_unique<CsvReader>(folder.write("r.csv", "id,value\nA,1\nB,2\nC,3\n")),
                {"value >= 2", "rainfall_where"}, {}, warnings);
  Row row;
  EXPECT_TRUE(table->next(row));
  const auto again = table->again();
  EXPECT_TRUE(again->next(row));
  EXPECT_EQ(row.fields[0], "B");
  EXPECT_EQ(row.line, 3U);
  EXPECT_TRUE(again->next(row));
  EXPECT_FALSE(again->next(row));
}

}  // namespace
}  // namespace thiessen
