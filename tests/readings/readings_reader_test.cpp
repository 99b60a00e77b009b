#include "readings/readings_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "readings/table_readings.h"

namespace thiessen {
namespace {

using namespace table_readings;

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
