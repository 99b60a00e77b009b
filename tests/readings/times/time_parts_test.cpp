#include "readings/times/time_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

TimeCandidates table(const Texts& header, const Texts& row, const Texts& stations = {}) {
  return {header, [=] { return row; },
          [=](std::size_t column) {
            return std::ranges::find(stations, header[column]) == stations.end();
          }};
}

/// The time of the first row, where it stands in several columns.
std::string time_of(const Texts& header, const Texts& row, const Texts& stations = {}) {
  std::optional<TimeColumns> columns = time_in_parts(table(header, row, stations));
  if (!columns) return "none";
  return std::string(columns->text({1, {row.begin(), row.end()}, false}));
}

std::string meant(const Texts& header, const Texts& row) {
  return time_fields_meant(table(header, row, {"a"}), 0).plain();
}

TEST(TimeParts, are_those_of_a_date_with_a_clock_or_without) {
  EXPECT_EQ(time_of({"YEAR", "MO", "DY", "HR", "a"}, {"2020", "1", "2", "0", "4"}),
            "2020-01-02 00:00");
  EXPECT_EQ(time_of({"YEAR", "MO", "DY", "a"}, {"2020", "1", "2", "4"}), "2020-01-02");
  EXPECT_EQ(time_of({"year", "month", "day", "hour", "minute", "second", "a"},
                    {"2020", "1", "2", "3", "4", "5", "9"}),
            "2020-01-02 03:04:05");
  EXPECT_EQ(time_of({"year", "month", "a"}, {"2010", "1", "4"}), "2010-01");
  EXPECT_EQ(time_of({"year", "month", "a"}, {"2010", "Feb", "4"}), "2010-02");
  EXPECT_EQ(time_of({"YEAR", "DOY", "a"}, {"2010", "60", "4"}), "2010-03-01");
  EXPECT_EQ(time_of({"year", "doy", "hour", "a"}, {"2010", "60", "6", "4"}), "2010-03-01 06:00");
  EXPECT_EQ(time_of({"day", "month", "year", "a"}, {"2", "1", "2010", "4"}), "2010-01-02");
  EXPECT_EQ(time_of({"year", "month", "day", "doy", "a"}, {"2010", "3", "1", "60", "4"}),
            "2010-03-01");
  EXPECT_EQ(time_of({"year", "month", "day", "time", "a"}, {"2010", "3", "1", "06:30", "4"}),
            "2010-03-01 06:30");
}

TEST(TimeParts, may_have_an_hour_and_its_minute_in_one_number) {
  for (const auto& [number, clock] :
       {std::pair("0", "0000"), std::pair("100", "0100"), std::pair("2400", "2400")})
    EXPECT_EQ(time_of({"year", "doy", "hhmm", "a"}, {"2010", "1", number, "4"}),
              std::string("2010-01-01 ") + clock);
}

TEST(TimeParts, are_none_where_the_first_row_has_other_texts) {
  EXPECT_EQ(time_of({"year", "month", "a"}, {"10", "1", "4"}), "none");
  EXPECT_EQ(time_of({"year", "month", "a"}, {"2010", "13", "4"}), "none");
  EXPECT_EQ(time_of({"year", "month", "day", "a"}, {"2010", "1", "32", "4"}), "none");
  EXPECT_EQ(time_of({"year", "doy", "a"}, {"2010", "367", "4"}), "none");
  EXPECT_EQ(time_of({"year", "month", "day", "hour", "a"}, {"2010", "1", "1", "25", "4"}), "none");
}

TEST(TimeParts, are_none_where_more_than_a_month_is_told_and_no_day) {
  EXPECT_EQ(time_of({"year", "a"}, {"2010", "4"}), "none");
  EXPECT_EQ(time_of({"year", "month", "dekad", "a"}, {"2010", "1", "2", "4"}), "none");
  EXPECT_EQ(time_of({"year", "month", "hour", "a"}, {"2010", "1", "2", "4"}), "none");
  EXPECT_EQ(time_of({"year", "day", "a"}, {"2010", "60", "4"}), "none");
  EXPECT_EQ(time_of({"month", "day", "a"}, {"1", "2", "4"}), "none");
}

TEST(TimeParts, are_no_columns_of_stations) {
  EXPECT_EQ(time_of({"year", "month", "day"}, {"2010", "3", "1"}, {"day"}), "2010-03");
  EXPECT_EQ(time_of({"year", "mm", "dd"}, {"2010", "3", "1"}, {"mm", "dd"}), "none");
}

TEST(TimeParts, may_be_known_by_their_names_alone) {
  EXPECT_TRUE(time_in_parts(table({"year", "month", "a"}, {})));
}

TEST(TimeFieldsMeant, name_the_columns_and_the_format_that_the_first_row_wants) {
  EXPECT_EQ(meant({"year", "month", "day", "a"}, {"10", "1", "2", "4"}),
            "time_field = year time_field = month time_field = day time_format = '%y %m %d' reads "
            "the time in these columns");
  EXPECT_EQ(meant({"year", "day", "a"}, {"2010", "60", "4"}),
            "time_field = year time_field = day time_format = '%Y %j' reads the time in these "
            "columns");
  EXPECT_EQ(meant({"year", "week", "a"}, {"2010", "7", "4"}),
            "time_field = year time_field = week reads the time in these columns");
  EXPECT_EQ(meant({"date", "hour", "a"}, {"31/12/2010", "H1", "4"}),
            "time_field = date time_field = hour reads the time in these columns");
}

TEST(TimeFieldsMeant, name_a_date_beside_a_clock_of_an_own_form) {
  EXPECT_EQ(meant({"time", "date", "a"}, {"06h00", "2010-12-31", "4"}),
            "time_field = date time_field = time reads the time in these columns");
  EXPECT_EQ(meant({"time", "date", "a"}, {"storm 1", "spring", "4"}), "");
}

TEST(TimeFieldsMeant, name_a_date_in_parts_beside_the_number_of_a_row) {
  EXPECT_EQ(meant({"id", "year", "month", "day", "a"}, {"1", "2010", "1", "31", "4"}),
            "time_field = year time_field = month time_field = day reads the time in these "
            "columns");
}

TEST(TimeFieldsMeant, are_none_where_the_time_is_whole) {
  EXPECT_EQ(meant({"time", "hour", "a"}, {"2010-12-31 06:00", "6", "4"}), "");
  EXPECT_EQ(meant({"date", "year", "month", "a"}, {"2010-12-31", "2010", "12", "4"}), "");
  EXPECT_EQ(meant({"event", "year", "a"}, {"storm 1", "2010", "4"}), "");
  EXPECT_EQ(meant({"year", "a", "b"}, {"2010", "4", "8"}), "");
  EXPECT_EQ(meant({"date", "min", "max"}, {"2010-12-31", "4", "8"}), "") << "no minute";
}

}  // namespace
}  // namespace thiessen
