#include "readings/stations/station_in_name.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "readings/readings_layout.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

const std::vector<Station> stations = {{"G44", {}}, {"7", {}}, {"rr_7", {}}, {"North Hill", {}}};

std::string in_name(const std::string& file) {
  return station_in_name(file, ReadingsStations(stations, {}));
}

TEST(StationInName, is_the_name_or_a_part_of_it_between_marks) {
  EXPECT_EQ(in_name("G44.csv"), "G44");
  EXPECT_EQ(in_name("obs/2020/rain_G44_2020.csv.gz"), "G44");
  EXPECT_EQ(in_name("North Hill-daily.csv"), "North Hill");
  EXPECT_EQ(in_name("G445.csv"), "");
  EXPECT_EQ(in_name("G44/2020.csv"), "") << "of a folder's name nothing counts";
}

TEST(StationInName, is_the_longest_where_one_lies_in_another) {
  EXPECT_EQ(in_name("rr_7.csv"), "rr_7");
  EXPECT_EQ(in_name("daily_7.csv"), "7");
}

TEST(StationInName, is_an_error_where_it_may_be_several) {
  EXPECT_TRUE(contains(complaint_of([] { in_name("G44_7.csv"); }),
                       "G44_7.csv: its name tells several stations: 'G44', '7'"));
}

TEST(StationInName, is_a_column_of_a_table_that_names_none) {
  const TemporaryFolder folder;
  const ReadingsStations known(stations, {});
  auto table = std::make_unique<CsvReader>(folder.write("G44.csv", "date,rain\n2020-01-01,5\n"));
  EXPECT_TRUE(names_no_station(*table, known));
  EXPECT_FALSE(names_no_station(CsvReader(folder.write("a.csv", "date,7\n1,2\n")), known));
  EXPECT_FALSE(names_no_station(CsvReader(folder.write("b.csv", "date,id,p\n1,2,3\n")), known));
  const auto with_station = of_station(std::move(table), "G44");
  EXPECT_EQ(with_station->header(), (std::vector<std::string>{"date", "rain", "station"}));
  EXPECT_EQ(with_station->columns_in_file(), 2U);
  for (const auto& read : {with_station->again(), with_station->first_rows()}) {
    Row row;
    ASSERT_TRUE(read->next(row));
    EXPECT_EQ(row.fields, (std::vector<std::string_view>{"2020-01-01", "5", "G44"}));
    EXPECT_FALSE(read->next(row));
  }
}

TEST(StationInName, is_no_column_that_a_message_lists) {
  const TemporaryFolder folder;
  const auto table = of_station(
      std::make_unique<CsvReader>(folder.write("G44.csv", "date,depth\n2020-01-01,5\n")), "G44");
  ReadingsOptions options;
  options.station_field = station_of_name;
  EXPECT_TRUE(
      contains(complaint_of([&] { find_layout(*table, ReadingsStations(stations, {}), options); }),
               "or the like; the columns are 'date', 'depth' | 'value_field' names it"));
}

}  // namespace
}  // namespace thiessen
