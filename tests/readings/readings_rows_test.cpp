#include "readings/readings_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "readings/long_tables.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

/// Rows of `rain,station,time`: the layout says where each is.
class LongRowsTest : public testing::Test {
 protected:
  LongRows rows(const std::string& text) {
    return {long_tables::source_of(
                std::make_unique<CsvReader>(folder.write("r.csv", "rain,station,time\n" + text)),
                gauges, warnings),
            {true, 2, 1, 0}};
  }
  static std::vector<std::string> complaints(LongRows& rows) {
    auto sentences = complaints_of([&] { rows.source().findings.conclude(1); });
    for (std::string& sentence : sentences) sentence.erase(0, sentence.find("r.csv"));
    return sentences;
  }

  TemporaryFolder folder;
  std::vector<Station> gauges = long_tables::stations(2);
  Warnings warnings;
};

TEST_F(LongRowsTest, have_a_time_a_station_and_an_amount) {
  LongRows table = rows("1.5,S1, 2013 \nNA,S0,b\n");
  LongRow row;
  ASSERT_TRUE(table.next(row));
  EXPECT_EQ(row.line, 2U);
  EXPECT_EQ(row.time, " 2013 ") << "a time is as it is written";
  EXPECT_TRUE(row.has_station);
  EXPECT_EQ(row.station, StationIndex{1});
  EXPECT_EQ(row.amount, 1.5);
  ASSERT_TRUE(table.next(row));
  EXPECT_EQ(row.station, StationIndex{0});
  EXPECT_TRUE(std::isnan(row.amount));
  EXPECT_FALSE(table.next(row));
  EXPECT_TRUE(table.time().has(2));
}

TEST_F(LongRowsTest, without_a_time_are_passed_over_with_a_complaint_and_their_readings_checked) {
  LongRows table = rows("1,S0, \nx,S0,\n1,S0,a\n");
  LongRow row;
  ASSERT_TRUE(table.next(row));
  EXPECT_EQ(row.line, 4U);
  EXPECT_FALSE(table.next(row));
  EXPECT_EQ(complaints(table),
            (std::vector<std::string>{
                "r.csv:2: the time is empty", "r.csv:3: the time is empty",
                "r.csv:3: reading 'x' of station 'S0' is no number | missing = x takes it "
                "for a gap, trace = x for 0"}));
}

TEST_F(LongRowsTest, of_unknown_stations_have_a_time_and_no_station) {
  LongRows table = rows("1,X,a\nbad,X,b\n1,,c\n1,,d\n");
  LongRow row;
  for (const char* time : {"a", "b", "c", "d"}) {
    ASSERT_TRUE(table.next(row));
    EXPECT_EQ(row.time, time);
    EXPECT_FALSE(row.has_station);
  }
  EXPECT_FALSE(table.next(row));
  const auto found = complaints(table);
  ASSERT_EQ(found.size(), 2U) << "each station once, and what it reads is not looked at";
  EXPECT_TRUE(found[0].starts_with("r.csv:2: unknown station 'X' | 'ignore_unknown'"));
  EXPECT_EQ(found[1], "r.csv:4: unknown station ''");
}

TEST_F(LongRowsTest, that_the_table_cannot_read_are_told_with_the_others) {
  LongRows table = rows("-1,S0,a\n1,S0\n");
  LongRow row;
  EXPECT_TRUE(table.next(row));
  EXPECT_FALSE(table.next(row));
  const auto found = complaints(table);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].starts_with("r.csv:2: negative reading"));
  EXPECT_EQ(found[1], "r.csv:3: row has 2 fields, the header has 3");
}

TEST_F(LongRowsTest, can_be_had_once_more_from_the_beginning) {
  LongRows table = rows("1,S0,a\n2,S0,b\n");
  LongRow row;
  while (table.next(row)) {
  }
  const auto again = table.again();
  ASSERT_NE(again, nullptr);
  Row first;
  ASSERT_TRUE(again->next(first));
  EXPECT_EQ(first.fields[2], "a");
}

}  // namespace
}  // namespace thiessen
