#include "files/tables/table_file.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

/// A table that nothing is warned of.
std::unique_ptr<Table> opened(const std::string& file, char separator = '\0') {
  static Warnings warnings;
  Source source;
  source.file = file;
  source.csv.separator = separator;
  auto table = open_table(source, warnings);
  EXPECT_TRUE(warnings.messages().empty());
  return table;
}

Texts first_row(Table& table) {
  Row row;
  EXPECT_TRUE(table.next(row));
  return {row.fields.begin(), row.fields.end()};
}

TEST(TableFile, is_a_csv_whose_separator_is_a_comma_unless_told) {
  const TemporaryFolder folder;
  const std::string file = folder.write("r.csv", "time,A;B\n1,2;3\n");
  EXPECT_EQ(opened(file)->header(), (Texts{"time", "A;B"}));
  EXPECT_EQ(opened(file, ';')->header(), (Texts{"time,A", "B"}));
  EXPECT_EQ(first_row(*opened(file)), (Texts{"1", "2;3"}));
  EXPECT_EQ(opened(file)->header_line(), 1U);
}

TEST(TableFile, may_be_anything_that_gdal_reads) {
  const TemporaryFolder folder;
  const auto table = opened(
      folder.write("r.geojson", R"({"type":"Feature","properties":{"time":"2013-08-01","A":"1.50"},
        "geometry":null})"),
      ';');
  EXPECT_EQ(table->header(), (Texts{"time", "A"}));
  EXPECT_EQ(table->header_line(), 0U);
  EXPECT_EQ(first_row(*table), (Texts{"2013-08-01", "1.50"}));
}

TEST(TableFile, of_a_csv_has_no_layers) {
  const TemporaryFolder folder;
  Source source;
  source.file = folder.write("r.csv", "time,A\n1,2\n");
  source.layer = "rain";
  source.layer_setting = "rainfall_layer";
  Warnings warnings;
  EXPECT_EQ(complaint_of([&] { open_table(source, warnings); }),
            source.file + ": a CSV file has no layers: rainfall_layer = rain");
}

TEST(TableFile, has_the_rows_that_the_filter_keeps_by_the_types_of_its_fields) {
  const TemporaryFolder folder;
  Source source;
  source.file = folder.write("r.geojson", R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{"time":"a","A":9},"geometry":null},
      {"type":"Feature","properties":{"time":"b","A":10},"geometry":null}]})");
  source.where = "A > 9";
  Warnings warnings;
  EXPECT_EQ(first_row(*open_table(source, warnings)), (Texts{"b", "10"}));
}

TEST(TableFile, that_is_not_there_is_an_error) {
  const TemporaryFolder folder;
  EXPECT_EQ(complaint_of([&] { opened(folder.path("no.csv")); }),
            folder.path("no.csv") + ": No such file or directory");
}

}  // namespace
}  // namespace thiessen
