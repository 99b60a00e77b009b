#include "readings/readings_wide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "readings/table_readings.h"

namespace thiessen {
namespace {

using namespace table_readings;

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
  EXPECT_EQ(refused.hints, Texts{"'rainfall_decimal_comma' reads 1,5 as 1.5"});
  reader.options.decimal_comma = true;
  expect_readings(reader.read("time,A\n1,\"1,5\"\n2,\"-99,9\"\n3,2\n"), {"1", "2", "3"},
                  {{1.5}, {silent}, {2}});
  EXPECT_EQ(reader.read("time,A\n1,1.5\n").sentences,
            Texts{"r.csv:2: reading '1.5' of station 'A' has a decimal point, and numbers are read "
                  "with decimal commas"});
}

TEST(WideReadings, name_the_columns_in_which_the_time_seems_to_stand) {
  Reader reader({"A"});
  const std::string weeks = "year,week,A\n2010,1,4\n2010,2,8\n";
  const Outcome unknown = reader.read(weeks);
  EXPECT_EQ(unknown.sentences, Texts{"r.csv:1: unknown station 'week'"});
  EXPECT_EQ(unknown.hints,
            Texts{"time_field = year time_field = week reads the time in these columns"});
  reader.options.ignore_unknown = true;
  const Outcome ignored = reader.read("year,week,A\n2010,1,4\n");
  EXPECT_EQ(ignored.sentences,
            Texts{"r.csv:1: its time seems to stand in more columns than 'year'"});
  EXPECT_EQ(ignored.hints,
            Texts{unknown.hints.at(0) + ", time_field = year that in this one alone"});
  reader.options.time_fields = {"year"};
  expect_readings(reader.read("year,week,A\n2010,1,4\n"), {"2010"}, {{4}});
  reader.options.time_fields = {"year", "week"};
  expect_readings(reader.read(weeks), {"2010 1", "2010 2"}, {{4}, {8}});
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

TEST(WideReadings, say_how_lines_above_the_header_are_passed_over) {
  const Outcome titled = Reader().read("Report,,,\n,,,\nWhen,A,B,C\n2020,1,2,3\n");
  EXPECT_EQ(titled.sentences,
            Texts{"r.csv:1: no column is called as a station of 'stations', such as 'A'; the "
                  "columns are 'Report', '', '', ''"});
  EXPECT_EQ(titled.hints,
            Texts{"line 3 names stations: rainfall_skip = 2 takes it for the header"});
  EXPECT_EQ(Reader().read("Report\nWhen,A,B,C\n").hints,
            Texts{"where lines stand above its header, 'rainfall_skip' says how many"});
  EXPECT_EQ(Reader({"1", "2"}).read("Report,,\n2020,1,1\n2021,1,2\n").hints.at(0).substr(0, 6),
            "line 3")
      << "readings may look like ids";
  EXPECT_EQ(Reader().read("Report,\n2020,1\n").hints.at(0).substr(0, 5), "where");
}

TEST(WideReadings, refuse_two_columns_of_one_station) {
  EXPECT_EQ(Reader().read("time,A,\" A\",B,C\n").sentences,
            Texts{"r.csv:1: columns 2 and 3 are both of station 'A'"});
}

TEST(WideReadings, may_have_the_time_in_a_named_column) {
  Reader reader;
  reader.options.time_fields = {"When"};
  expect_readings(reader.read("A,B,when,C\n1,2,x,3\n"), {"x"}, {{1, 2, 3}});
  reader.options.time_fields = {"date"};
  EXPECT_EQ(reader.read("A,B,when,C\n").sentences,
            Texts{"r.csv:1: there is no column 'date'; the columns are 'A', 'B', 'when', 'C'"});
}

}  // namespace
}  // namespace thiessen
