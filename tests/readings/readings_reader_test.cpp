#include "readings/readings_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "text/csv_reader.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;
constexpr double silent = -1;  // stands for NaN, which equals nothing, in what is compared

std::vector<Station> stations_called(const Texts& ids) {
  std::vector<Station> stations;
  for (const std::string& id : ids) stations.push_back({id, {}, stations.size() + 2});
  return stations;
}

struct Outcome {
  Texts times;
  std::vector<std::vector<double>> readings;
  Texts sentences;
  Texts hints;
  Texts warnings;
  std::size_t unlisted = 0;
};

class Reader {
 public:
  Reader(Texts ids = {"A", "B", "C"}) : stations_(stations_called(ids)) {}

  ReadingsOptions options;
  Texts passed_over;

  Outcome read(const std::string& text) {
    const TemporaryFolder folder;
    const std::string path = folder.write("r.csv", text);
    Outcome outcome;
    Warnings warnings;
    try {
      read_steps(path, warnings, outcome);
    } catch (const Error& error) {
      for (const Message& message : error.messages()) {
        outcome.sentences.push_back(message.sentence().substr(path.size() - 5));
        outcome.hints.push_back(message.hint.plain());
      }
      outcome.unlisted = error.unlisted();
    }
    for (const Message& message : warnings.messages()) {
      outcome.warnings.push_back(message.sentence().substr(path.size() - 5));
    }
    return outcome;
  }

 private:
  void read_steps(const std::string& path, Warnings& warnings, Outcome& outcome) {
    const auto readings =
        open_readings(std::make_unique<CsvReader>(path), stations_, passed_over, options, warnings);
    TimeStep step;
    while (readings->next(step)) {
      outcome.times.push_back(step.time);
      outcome.readings.emplace_back(step.readings.begin(), step.readings.end());
      for (double& reading : outcome.readings.back()) {
        if (std::isnan(reading)) reading = silent;
      }
    }
    EXPECT_FALSE(readings->next(step)) << "the end stays the end";
  }

  std::vector<Station> stations_;
};

void expect_readings(const Outcome& outcome, const Texts& times,
                     const std::vector<std::vector<double>>& readings) {
  EXPECT_EQ(outcome.sentences, Texts{});
  EXPECT_EQ(outcome.times, times);
  EXPECT_EQ(outcome.readings, readings);
}

TEST(WideReadings, are_put_in_the_stations_order) {
  const Outcome outcome = Reader().read("time,C,A,B\n2020,3,1,2.5\n2021,6,+4,.5e1\n");
  expect_readings(outcome, {"2020", "2021"}, {{1, 2.5, 3}, {4, 5, 6}});
  EXPECT_EQ(outcome.warnings, Texts{});
}

TEST(WideReadings, keep_the_times_and_the_ids_as_they_are) {
  const Outcome outcome = Reader({"a b", "007", "=1+1", " x"})
                              .read("\"t, x\",a b,007,=1+1,\" x\"\n\" 1,5 \",1,2,3,4\n");
  expect_readings(outcome, {" 1,5 "}, {{1, 2, 3, 4}});
}

TEST(WideReadings, know_everything_that_means_no_reading) {
  for (const std::string gap : {"", " ", "NA", "na", "N/A", "NaN", "nan", "NULL", "-", "-999",
                                "-999.000", "-9.99e2", "-9999", "-99.9", "-99.90", " NA "}) {
    expect_readings(Reader().read("time,A,B,C\n1," + gap + ",7," + gap + "\n"), {"1"},
                    {{silent, 7, silent}});
  }
}

TEST(WideReadings, take_further_texts_for_a_gap_or_a_trace) {
  Reader reader;
  reader.options.missing = {"M", "-777", "8888"};
  reader.options.trace = {"T", "-1", "-"};
  expect_readings(reader.read("time,A,B,C\n1,m,T,8888.0\n2,-777.0,-1.0,1\n3,-,0,-999\n"),
                  {"1", "2", "3"}, {{silent, 0, silent}, {silent, 0, 1}, {0, 0, silent}});
}

TEST(WideReadings, make_negative_zero_plain) {
  const Outcome outcome = Reader({"A"}).read("time,A\n1,-0.0\n");
  ASSERT_EQ(outcome.readings.size(), 1u);
  EXPECT_FALSE(std::signbit(outcome.readings[0][0]));
}

TEST(WideReadings, report_every_bad_field_with_line_station_and_text) {
  const Outcome outcome =
      Reader().read("time,A,B,C\n1,1,-2,3\n2,1,x,1e400\n3,0x1,inf,１\n4,1,2,3\n");
  EXPECT_EQ(outcome.sentences,
            (Texts{"r.csv:2: negative reading '-2' of station 'B'",
                   "r.csv:3: reading 'x' of station 'B' is no number",
                   "r.csv:3: reading '1e400' of station 'C' is outside the range of numbers",
                   "r.csv:4: reading '0x1' of station 'A' is no number",
                   "r.csv:4: reading 'inf' of station 'B' is no number",
                   "r.csv:4: reading '１' of station 'C' is no number"}));
  EXPECT_EQ(outcome.hints[0], "missing = -2 takes it for a gap, trace = -2 for 0");
  EXPECT_EQ(outcome.hints[1], "missing = x takes it for a gap, trace = x for 0");
  EXPECT_EQ(outcome.times, Texts{}) << "no step follows a bad row";
}

TEST(WideReadings, report_bad_rows_and_bad_fields_together_in_their_order) {
  const Outcome outcome = Reader().read("time,A,B,C\n1,x,2,3\n2,1\n3,1,y,3\n");
  EXPECT_EQ(outcome.sentences, (Texts{"r.csv:2: reading 'x' of station 'A' is no number",
                                      "r.csv:3: row has 2 fields, the header has 4",
                                      "r.csv:4: reading 'y' of station 'B' is no number"}));
}

TEST(WideReadings, report_a_million_bad_fields_in_twenty_lines) {
  std::string text = "time,A\n";
  for (int i = 0; i < 1'000'000; ++i) text += std::to_string(i) + ",x\n";
  const Outcome outcome = Reader({"A"}).read(text);
  EXPECT_EQ(outcome.sentences.size(), 20u);
  EXPECT_EQ(outcome.unlisted, 999'980u);
}

TEST(WideReadings, may_have_a_decimal_comma_only_when_told) {
  Reader reader({"A"});
  const Outcome refused = reader.read("time,A\n1,\"1,5\"\n");
  EXPECT_EQ(refused.sentences, Texts{"r.csv:2: reading '1,5' of station 'A' is no number"});
  EXPECT_EQ(refused.hints, Texts{"'decimal_comma' reads 1,5 as 1.5"});
  reader.options.decimal_comma = true;
  expect_readings(reader.read("time,A\n1,\"1,5\"\n2,\"-99,9\"\n3,2\n"), {"1", "2", "3"},
                  {{1.5}, {silent}, {2}});
  EXPECT_EQ(reader.read("time,A\n1,1.5\n").sentences,
            Texts{"r.csv:2: reading '1.5' of station 'A' is no number"});
}

TEST(WideReadings, refuse_a_time_given_twice_or_not_at_all) {
  const Outcome outcome = Reader().read("time,A,B,C\nx,1,2,3\ny,1,2,3\n ,1,2,3\nx,1,2,3\n");
  EXPECT_EQ(outcome.sentences,
            (Texts{"r.csv:4: the time is empty", "r.csv:5: time 'x' is already in line 2"}));
}

TEST(WideReadings, refuse_unknown_stations_each_by_name) {
  const Outcome outcome = Reader().read("\ntime,A,X,a,\n1,1,2,3,4\n");
  EXPECT_EQ(outcome.sentences,
            (Texts{"r.csv:2: unknown station 'X'", "r.csv:2: unknown station 'a'",
                   "r.csv:2: column 5 has no name"}));
  EXPECT_NE(outcome.hints[0].find("'ignore_unknown'"), std::string::npos);
}

TEST(WideReadings, pass_over_unknown_stations_when_told) {
  Reader reader;
  reader.options.ignore_unknown = true;
  std::string header = "time,A,B,C";
  std::string row = "1,1,2,3";
  for (int i = 0; i < 12; ++i) {
    header += ",X" + std::to_string(i);
    row += ",-5";
  }
  const Outcome outcome = reader.read(header + "\n" + row + "\n");
  expect_readings(outcome, {"1"}, {{1, 2, 3}});
  EXPECT_EQ(outcome.warnings,
            Texts{"r.csv: 12 unknown stations are passed over: 'X0', 'X1', 'X2', 'X3', 'X4', 'X5', "
                  "'X6', 'X7', 'X8', 'X9' and 2 more"});
}

TEST(WideReadings, pass_over_filtered_stations_in_silence) {
  Reader reader;
  reader.passed_over = {"D"};
  const Outcome outcome = reader.read("time,A,B,C,D\n1,1,2,3,rubbish\n");
  expect_readings(outcome, {"1"}, {{1, 2, 3}});
  EXPECT_EQ(outcome.warnings, Texts{});
}

TEST(WideReadings, warn_of_stations_without_readings) {
  EXPECT_EQ(Reader().read("time,A,C\n1,1,NA\n2,1,2\n").warnings,
            Texts{"r.csv: station 'B' has no readings"});
  EXPECT_EQ(Reader().read("time,B,C\n1,1,NA\n").warnings,
            Texts{"r.csv: 2 stations have no readings: 'A', 'C'"});
  EXPECT_EQ(Reader().read("time,A,B\n").warnings, Texts{"r.csv: there is no time step"})
      << "there is no time at all";
}

TEST(WideReadings, warn_once_of_absurd_amounts) {
  const Outcome one = Reader({"A"}).read("time,A\n1,30000\n2,1e9\n");
  expect_readings(one, {"1", "2"}, {{30000}, {1e9}});
  EXPECT_EQ(one.warnings,
            Texts{"r.csv:3: reading '1e9' of station 'A' is more than falls anywhere in a year"});
  EXPECT_EQ(
      Reader({"A"}).read("time,A\n1,1e9\n2,1e9\n3,1e9\n").warnings,
      Texts{"r.csv:2: reading '1e9' of station 'A' is more than falls anywhere in a year, and "
            "so are 2 more"});
}

TEST(WideReadings, need_a_column_of_readings) {
  EXPECT_EQ(Reader().read("time\n1\n").sentences,
            Texts{"r.csv:1: has the one column 'time', and none of readings"});
}

TEST(WideReadings, refuse_two_columns_of_one_station) {
  EXPECT_EQ(Reader().read("time,A,\" A\",B,C\n").sentences,
            Texts{"r.csv:1: columns 2 and 3 are both of station 'A'"});
}

TEST(WideReadings, may_have_the_time_in_a_named_column) {
  Reader reader;
  reader.options.time_field = "When";
  expect_readings(reader.read("A,B,when,C\n1,2,x,3\n"), {"x"}, {{1, 2, 3}});
  reader.options.time_field = "date";
  EXPECT_EQ(reader.read("A,B,when,C\n").sentences,
            Texts{"r.csv:1: there is no column 'date'; the columns are 'A', 'B', 'when', 'C'"});
}

TEST(Layout, is_long_where_a_station_and_a_value_column_are_found) {
  for (const std::string header :
       {"time,station,rain", "Date,ID,PRCP_MM", "datetime,Gauge,Rain (mm)", "date,stnid,p",
        "time,name,precip.in", "time,code,Value", "time,num,rainfall_mm/h",
        "date,site_no,prcp [cm]"}) {
    expect_readings(Reader({"A"}).read(header + "\n1,A,2\n"), {"1"}, {{2}});
  }
}

TEST(Layout, is_wide_where_a_header_is_a_stations_id) {
  expect_readings(Reader({"station", "p"}).read("time,station,p\n1,2,3\n"), {"1"}, {{2, 3}});
  Reader filtered({"station"});
  filtered.passed_over = {"p"};
  expect_readings(filtered.read("time,station,p\n1,2,3\n"), {"1"}, {{2}});
  EXPECT_EQ(Reader({"A"}).read("time,station,rain_gauge\n1,2,3\n").sentences.size(), 1u)
      << "'gauge' is no unit";
}

TEST(Layout, follows_the_users_columns) {
  Reader reader({"A", "B"});
  reader.options.time_field = "Zeit";
  reader.options.station_field = "สถานี";
  reader.options.value_field = "雨";
  expect_readings(reader.read("雨,id,สถานี,Zeit\n1,x,A,t\n2,y,B,t\n"), {"t"}, {{1, 2}});
}

TEST(Layout, names_what_was_looked_for_and_what_was_found) {
  EXPECT_EQ(Reader().read("hour,station,rain\n").sentences,
            Texts{"r.csv:1: no column is called time, date, datetime, date_time, timestamp, datum, "
                  "zeit or the like; the columns are 'hour', 'station', 'rain'"});
  Reader reader;
  reader.options.value_field = "x";
  EXPECT_EQ(reader.read("time,station,rain\n").sentences,
            Texts{"r.csv:1: there is no column 'x'; the columns are 'time', 'station', 'rain'"});
  reader.options.value_field = "station";
  EXPECT_EQ(reader.read("time,station,rain\n").sentences,
            Texts{"r.csv:1: time, station and value are not three columns; the columns are 'time', "
                  "'station', 'rain'"});
}

TEST(LongReadings, gather_the_rows_of_a_time_from_all_over_the_file) {
  const Outcome outcome =
      Reader().read("station,date,prcp_mm\nB,y,4\nA,x,1\nA,y,2\nB,x,NA\n C ,x,3\n");
  expect_readings(outcome, {"y", "x"}, {{2, 4, silent}, {1, silent, 3}});
  EXPECT_EQ(outcome.warnings, Texts{});
}

TEST(LongReadings, say_of_both_lines_that_one_time_is_given_twice) {
  const Outcome outcome = Reader().read(
      "station,date,prcp\nA,x,1\nB,x,1\nD,x,1\n\nA,y,1\nA,x,NA\nB,y,1\nB,x,1\nA,x,2\n");
  EXPECT_EQ(outcome.sentences,
            (Texts{"r.csv:4: unknown station 'D'",
                   "r.csv:7: the reading of station 'A' at 'x' is already in line 2",
                   "r.csv:9: the reading of station 'B' at 'x' is already in line 3",
                   "r.csv:10: the reading of station 'A' at 'x' is already in line 7"}));
}

TEST(LongReadings, report_every_bad_row_before_the_first_step) {
  const Outcome outcome =
      Reader().read("station,date,prcp\nA,x,1\nB,x,-1\nA,,1\nX,x,1\nY,x,1\nX,y,1\nA\nC,x,z\n");
  EXPECT_EQ(outcome.times, Texts{});
  EXPECT_EQ(outcome.sentences,
            (Texts{"r.csv:3: negative reading '-1' of station 'B'", "r.csv:4: the time is empty",
                   "r.csv:5: unknown station 'X'", "r.csv:6: unknown station 'Y'",
                   "r.csv:8: row has 1 field, the header has 3",
                   "r.csv:9: reading 'z' of station 'C' is no number"}));
}

TEST(LongReadings, pass_over_unknown_and_filtered_stations) {
  Reader reader;
  reader.options.ignore_unknown = true;
  reader.passed_over = {"F"};
  const Outcome outcome =
      reader.read("station,date,prcp\nA,x,1\nF,x,bad\nX,x,bad\nB,x,2\nX,y,3\nA,z,4\n");
  expect_readings(outcome, {"x", "y", "z"},
                  {{1, 2, silent}, {silent, silent, silent}, {4, silent, silent}});
  EXPECT_EQ(outcome.warnings, (Texts{"r.csv: an unknown station is passed over: 'X'",
                                     "r.csv: station 'C' has no readings"}));
}

TEST(LongReadings, may_be_none) {
  expect_readings(Reader().read("station,date,prcp\n"), {}, {});
}

TEST(LongReadings, are_the_same_as_wide_ones) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  Texts ids;
  for (int i = 0; i < 50; ++i) ids.push_back("S" + std::to_string(i));
  std::string wide = "time";
  for (const std::string& id : ids) wide += "," + id;
  wide += "\n";
  Texts rows;
  for (int t = 0; t < 200; ++t) {
    wide += std::to_string(t);
    for (const std::string& id : ids) {
      const std::string value = random() % 3 == 0 ? "" : std::to_string(random() % 100) + ".5";
      wide += "," + value;
      rows.push_back(std::to_string(t) + "," + id + "," + value + "\n");
    }
    wide += "\n";
  }
  std::shuffle(rows.begin(), rows.end(), random);
  std::string scattered = "time,station,rain\n";
  for (const std::string& row : rows) scattered += row;
  const Outcome a = Reader(ids).read(wide);
  const Outcome b = Reader(ids).read(scattered);
  ASSERT_EQ(a.times.size(), 200u);
  ASSERT_EQ(b.times.size(), 200u);
  std::map<std::string, std::vector<double>> of_time;
  for (std::size_t i = 0; i < 200; ++i) of_time[a.times[i]] = a.readings[i];
  for (std::size_t i = 0; i < 200; ++i) EXPECT_EQ(of_time.at(b.times[i]), b.readings[i]);
}

}  // namespace
}  // namespace thiessen
