#include "readings/published/hourly_order.h"

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

const std::string header =
    "STATION,STATION_NAME,ELEVATION,LATITUDE,LONGITUDE,DATE,HPCP,Measurement Flag,Quality Flag\n";

class HourlyOrderTest : public testing::Test {
 protected:
  /// A row of station A: the hour of 1 January 2010, the value and the flags.
  static std::string at(const std::string& hour, const std::string& rest) {
    return "A,WEST,1,40,-105,20100101 " + hour + ":00," + rest + "\n";
  }
  std::unique_ptr<HourlyOrder> open(const std::string& rows) const {
    return std::make_unique<HourlyOrder>(
        std::make_unique<CsvReader>(folder_.write("r.csv", header + rows)));
  }
  /// The hours, values and flags of quality of all rows; an empty one is -.
  static Texts texts(Table& table) {
    Texts all;
    for (Row row; table.next(row);) {
      std::string text = std::string(row.fields[0]) + " " + std::string(row.fields[1].substr(6, 5));
      for (const std::string_view field : {row.fields[2], row.fields[3]})
        text += " " + (field.empty() ? "-" : std::string(field));
      all.push_back(text);
    }
    return all;
  }
  Texts read(const std::string& rows) const { return texts(*open(rows)); }

  const TemporaryFolder folder_;
};

TEST_F(HourlyOrderTest, has_dry_hours_between_two_rows_of_a_station) {
  const std::string rows =
      at("01", "0,g,") + at("04", "10, ,") +
      "B,EAST,1,40,-104,20100101 23:00,5,,\nB,EAST,1,40,-104,20100102 01:00,7,,\n";
  const Texts right = {"A 01 01 0 -", "A 01 02 0 -", "A 01 03 0 -", "A 01 04 10 -",
                       "B 01 23 5 -", "B 02 00 0 -", "B 02 01 7 -"};
  const auto table = open(rows);
  EXPECT_EQ(texts(*table), right);
  EXPECT_EQ(texts(*table->again()), right);
  EXPECT_EQ(table->place(1).line, 2U);
  EXPECT_EQ(table->place(2).line, 3U) << "a dry hour stands in the line that tells of it";
  EXPECT_EQ(table->place(4).line, 3U);
  EXPECT_EQ(table->place(7).line, 5U);
}

TEST_F(HourlyOrderTest, has_no_readings_in_missing_and_deleted_periods) {
  EXPECT_EQ(
      read(at("01", "99999,[,") + at("03", "99999,],") + at("05", "2,,")),
      (Texts{"A 01 01 99999 -", "A 01 02 - -", "A 01 03 99999 -", "A 01 04 0 -", "A 01 05 2 -"}));
  EXPECT_EQ(read(at("01", "99999,{,") + at("03", "99999,},")).at(1), "A 01 02 - -");
  EXPECT_EQ(read(at("01", "0,g,") + at("03", "4,],")),
            (Texts{"A 01 01 0 -", "A 01 02 - -", "A 01 03 4 -"}))
      << "until 1984 the last hour of a missing period may have rain";
}

TEST_F(HourlyOrderTest, has_no_readings_where_only_their_sum_is_known) {
  EXPECT_EQ(read(at("01", "99999,a,") + at("03", "60,A,") + at("05", "1,,")),
            (Texts{"A 01 01 99999 -", "A 01 02 - -", "A 01 03 - -", "A 01 04 0 -", "A 01 05 1 -"}));
  EXPECT_EQ(read(at("01", "99999,\",\",") + at("03", "60,A,")).at(1), "A 01 02 - -");
}

TEST_F(HourlyOrderTest, has_no_hours_where_a_station_lacks_a_month) {
  const std::string january = "A,WEST,1,40,-105,20100101 01:00,0,g,\n";
  EXPECT_EQ(read(january + "A,WEST,1,40,-105,20100201 01:00,0,g,\n").size(), 745U);
  EXPECT_EQ(read(january + "A,WEST,1,40,-105,20100301 01:00,0,g,\n").size(), 2U);
}

TEST_F(HourlyOrderTest, keeps_the_flags_of_quality_that_mean_a_fault) {
  EXPECT_EQ(read(at("01", "1,,Q") + at("02", "2,,Z") + at("03", "3,,q") + at("04", "4,,R")),
            (Texts{"A 01 01 1 Q", "A 01 02 2 -", "A 01 03 3 q", "A 01 04 4 R"}));
}

TEST_F(HourlyOrderTest, refuses_times_that_are_none_or_go_back) {
  const Texts complaints =
      complaints_of([&] { read(at("02", "1,,") + at("02", "1,,") + at("2x", "1,,")); });
  ASSERT_EQ(complaints.size(), 2U);
  EXPECT_EQ(complaints[0], folder_.path() +
                               "/r.csv:3: hour '20100101 02:00' of station 'A' is not after the "
                               "one above it | sort the rows by station and time");
  EXPECT_EQ(complaints[1],
            folder_.path() + "/r.csv:4: no hour such as 20100101 01:00: '20100101 2x:00'");
}

TEST_F(HourlyOrderTest, is_known_by_its_header) {
  EXPECT_TRUE(is_hourly_order_header({"STATION", "DATE", "HPCP", "Measurement Flag"}));
  EXPECT_FALSE(is_hourly_order_header({"STATION", "DATE", "HPCP"}))
      << "without flags missing hours look dry";
}

}  // namespace
}  // namespace thiessen
