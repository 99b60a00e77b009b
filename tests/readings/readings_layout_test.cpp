#include "readings/readings_layout.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/complaints.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

/// A table of which nobody reads more than the header.
class HeaderTable : public Table {
 public:
  explicit HeaderTable(Texts header) : header_(std::move(header)) {}
  const std::string& file() const override { return file_; }
  const Texts& header() const override { return header_; }
  std::size_t header_line() const override { return 4; }
  bool next(Row&) override { return false; }

 private:
  std::string file_ = "r.csv";
  Texts header_;
};

/// Finds the layout of a table with these stations.
struct Finder {
  Texts ids = {"A"};
  Texts passed_over = {};
  ReadingsOptions options = {};

  ReadingsLayout layout(const Texts& header) const {
    std::vector<Station> stations;
    for (const std::string& id : ids) stations.push_back({id, {}, 0});
    return find_layout(HeaderTable(header), ReadingsStations(stations, passed_over), options);
  }
  std::string complaint(const Texts& header) const {
    return complaint_of([&] { layout(header); });
  }
};

void expect_long(const ReadingsLayout& layout, std::size_t time, std::size_t station,
                 std::size_t value) {
  EXPECT_TRUE(layout.is_long);
  EXPECT_TRUE(layout.time.has(time));
  EXPECT_EQ(layout.station, station);
  EXPECT_EQ(layout.value, value);
}

TEST(Layout, is_long_where_a_station_and_a_value_column_are_found) {
  for (const Texts& header : {Texts{"time", "station", "rain"},
                              {"Date", "ID", "PRCP_MM"},
                              {"datetime", "Gauge", "Rain (mm)"},
                              {"date", "stnid", "p"},
                              {"time", "name", "precip.in"},
                              {"time", "code", "Value"},
                              {"time", "num", "rainfall_mm/h"},
                              {"date", "site_no", "prcp [cm]"},
                              {" date ", "staid", "p (inches)"}})
    expect_long(Finder().layout(header), 0, 1, 2);
  expect_long(Finder().layout({"value", "x", "station", "when", "time"}), 4, 2, 0);
}

TEST(Layout, a_value_may_have_a_unit_behind_its_name_and_nothing_else) {
  for (const char* value : {"rain_gauge", "rain_", "rainmm", "rain (mm) total", "rain(", "rains"})
    EXPECT_FALSE(Finder().layout({"time", "station", value}).is_long) << value;
}

TEST(Layout, is_wide_where_a_header_is_a_stations_id) {
  EXPECT_FALSE((Finder{{"station", "p"}}.layout({"time", "station", "p"}).is_long));
  EXPECT_FALSE((Finder{{"station"}, {"p"}}.layout({"time", "station", "p"}).is_long))
      << "an id that the filter leaves out is one, too";
  EXPECT_FALSE((Finder{{"rain"}}.layout({"time", "station", "rain"}).is_long));
  EXPECT_FALSE(Finder().layout({"time", "A", "B"}).is_long);
}

TEST(Layout, of_a_wide_table_has_the_time_first_or_where_the_user_says) {
  Finder finder;
  EXPECT_TRUE(finder.layout({"B", "A", "time"}).time.has(0));
  finder.options.time_fields = {"When"};
  EXPECT_TRUE(finder.layout({"A", "when", "When"}).time.has(2)) << "the very name first";
  EXPECT_TRUE(finder.layout({"A", "B", " when"}).time.has(2));
  finder.options.time_fields = {"date"};
  EXPECT_EQ(finder.complaint({"A", "when"}),
            "r.csv:4: there is no column 'date'; the columns are 'A', 'when' | see 'time_field'");
}

TEST(Layout, is_long_where_the_user_names_a_column_of_one) {
  Finder finder{{"A"}, {}, {}};
  finder.options.time_fields = {"Zeit"};
  finder.options.station_field = "สถานี";
  finder.options.value_field = "雨";
  expect_long(finder.layout({"雨", "id", "สถานี", "Zeit"}), 3, 2, 0);
  Finder of_values{{"station", "x"}, {}, {}};
  of_values.options.value_field = "x";
  expect_long(of_values.layout({"time", "station", "x"}), 0, 1, 2);
}

TEST(Layout, names_what_was_looked_for_and_what_was_found) {
  const std::string found = "; the columns are 'hour', 'station', 'rain'";
  EXPECT_EQ(
      Finder().complaint({"hour", "station", "rain"}),
      "r.csv:4: no column is called time, date, datetime, date_time, timestamp, datum, zeit or "
      "the like" +
          found + " | 'time_field' names it");
  Finder finder;
  finder.options.value_field = "x";
  EXPECT_TRUE(contains(finder.complaint({"hour", "station", "rain"}), "no column"));
  EXPECT_EQ(finder.complaint({"time", "station", "rain"}),
            "r.csv:4: there is no column 'x'; the columns are 'time', 'station', 'rain' | see "
            "'value_field'");
  finder.options.value_field = "station";
  EXPECT_TRUE(finder.complaint({"time", "station", "rain"})
                  .starts_with("r.csv:4: time, station and value are not three columns; "));
  EXPECT_TRUE(contains(finder.complaint(Texts(30, "c")), " and 20 more"));
}

std::vector<std::size_t> time_columns(const ReadingsLayout& layout) {
  std::vector<std::size_t> fields;
  for (const TimeColumns::Column& column : layout.time.columns()) fields.push_back(column.field);
  return fields;
}

using Fields = std::vector<std::size_t>;

TEST(Layout, has_a_time_in_several_columns) {
  Finder finder;
  EXPECT_EQ(time_columns(finder.layout({"station", "Year", "Month", "Day", "rain"})),
            (Fields{1, 2, 3}));
  EXPECT_EQ(time_columns(finder.layout({"station", "date", "Year", "Month", "Day", "rain"})),
            Fields{1})
      << "a whole time before its parts";
  EXPECT_EQ(time_columns(finder.layout({"year", "month", "day", "hour", "A"})),
            (Fields{0, 1, 2, 3}));
  EXPECT_EQ(time_columns(finder.layout({"day", "A"})), Fields{0}) << "no year";
  finder.options.time_fields = {"d", "t"};
  EXPECT_EQ(time_columns(finder.layout({"t", "A", "d"})), (Fields{2, 0}));
}

TEST(Layout, has_a_time_in_years_and_months_or_days_of_the_year) {
  const Finder finder;
  EXPECT_EQ(time_columns(finder.layout({"YEAR", "MO", "DY", "HR", "A"})), (Fields{0, 1, 2, 3}));
  EXPECT_EQ(time_columns(finder.layout({"year", "month", "A"})), (Fields{0, 1}));
  EXPECT_EQ(time_columns(finder.layout({"YEAR", "DOY", "A"})), (Fields{0, 1}));
  EXPECT_EQ(time_columns(finder.layout({"station", "YEAR", "DOY", "rain"})), (Fields{1, 2}));
  EXPECT_EQ(time_columns(finder.layout({"", "YEAR", "DOY", "A"})), (Fields{1, 2}));
}

TEST(Layout, of_a_station_has_no_part_of_a_time) {
  const Finder finder{{"DY", "A"}};
  EXPECT_EQ(time_columns(finder.layout({"YEAR", "MO", "DY", "A"})), (Fields{0, 1}));
}

TEST(Layout, says_which_columns_of_the_time_are_not_read) {
  const Finder finder;
  EXPECT_EQ(finder.layout({"year", "week", "A"}).time_meant.plain(),
            "time_field = year time_field = week reads the time in these columns");
  EXPECT_TRUE(finder.layout({"year", "month", "A"}).time_meant.empty());
  EXPECT_TRUE(finder.layout({"time", "A", "B"}).time_meant.empty());
  try {
    finder.layout({"station", "year", "month", "dekad", "rain"});
    FAIL() << "a dekad is part of the time";
  } catch (const Error& error) {
    EXPECT_EQ(error.messages().at(0).hint.plain(),
              "time_field = year time_field = month time_field = dekad reads the time in these "
              "columns");
  }
}

TEST(Layout, of_a_wide_table_passes_over_an_index_without_a_name) {
  const Finder finder;
  const ReadingsLayout layout = finder.layout({"", "date", "A"});
  EXPECT_EQ(time_columns(layout), Fields{1});
  EXPECT_EQ(layout.index, std::size_t{0});
  EXPECT_EQ(time_columns(finder.layout({"", "A", "B"})), Fields{0}) << "it is the time itself";
}

/// A table of which the first row is known before it is read.
class FirstRowTable : public HeaderTable {
 public:
  FirstRowTable(Texts header, Texts row) : HeaderTable(std::move(header)), row_(std::move(row)) {}
  bool next(Row& row) override {
    if (is_read_) return false;
    is_read_ = true;
    row.fields.assign(row_.begin(), row_.end());
    return true;
  }
  std::unique_ptr<Table> again() const override {
    return std::make_unique<FirstRowTable>(header(), row_);
  }

 private:
  Texts row_;
  bool is_read_ = false;
};

/// How many columns the time has that is found.
std::size_t time_columns(const Texts& header, const Texts& row) {
  const std::vector<Station> stations = {{"A", {}, 0}};
  const FirstRowTable table(header, row);
  return find_layout(table, ReadingsStations(stations, {}), {}).time.columns().size();
}

TEST(Layout, a_date_and_a_clock_beside_it_are_the_time_together) {
  EXPECT_EQ(time_columns({"DATE", "TIME", "A"}, {"2020-01-01", "05:00", "1"}), 2U);
  EXPECT_EQ(time_columns({"station", "date", "hour", "rain"}, {"A", "01/01/2020", "24", "1"}), 2U);
  EXPECT_EQ(time_columns({"Data", "Hora UTC", "A"}, {"2019/01/01", "0000 UTC", "1"}), 2U);
}

TEST(Layout, a_column_that_holds_the_whole_time_needs_no_other) {
  const std::vector<Station> stations = {{"A", {}, 0}};
  const FirstRowTable long_table({"station", "time", "date", "rain"},
                                 {"A", "05:00", "2020-01-01 05:00", "1"});
  EXPECT_TRUE(find_layout(long_table, ReadingsStations(stations, {}), {}).time.has(2));
  EXPECT_EQ(time_columns({"date", "time", "A"}, {"2020-01-01 05:00", "05:00", "1"}), 1U);
  EXPECT_EQ(time_columns({"station", "date", "time", "rain"},
                         {"A", "2020-01-01", "2020-01-01T05:00", "1"}),
            1U);
  EXPECT_EQ(time_columns({"station", "date", "time", "datetime", "rain"},
                         {"A", "2020-01-01", "05:00", "2020-01-01 05:00", "1"}),
            1U);
  const FirstRowTable three({"station", "date", "time", "datetime", "rain"},
                            {"A", "2020-01-01", "05:00", "2020-01-01 05:00", "1"});
  EXPECT_TRUE(find_layout(three, ReadingsStations(stations, {}), {}).time.has(3));
}

TEST(Layout, is_long_by_its_header_whatever_the_stations_are) {
  EXPECT_TRUE(is_long_header({"station", "lon", "lat", "date", "rain_mm"}));
  EXPECT_TRUE(is_long_header({"id", "year", "month", "day", "prcp"}));
  EXPECT_FALSE(is_long_header({"station", "lon", "lat"}));
  EXPECT_FALSE(is_long_header({"date", "rain"}));
  EXPECT_FALSE(is_long_header({"station", "rain"}));
  EXPECT_FALSE(is_long_header({}));
}

}  // namespace
}  // namespace thiessen
