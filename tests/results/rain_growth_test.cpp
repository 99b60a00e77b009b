// Which steps of a series are added to a table, and what is said of them.
#include "results/rain_growth.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/complaints.h"

namespace thiessen {
namespace {

EarlierRain earlier(const std::string& text) {
  return {"r.csv",
          text.size(),
          [text](std::size_t at, std::span<char> into) {
            return text.substr(at).copy(into.data(), into.size());
          },
          {"time,A\n", 1, {1}}};
}

std::vector<std::string> said(RainGrowth& growth) {
  Warnings warnings;
  growth.conclude(warnings);
  std::vector<std::string> all;
  for (const Message& notice : warnings.notices()) all.push_back(notice.sentence());
  for (const Message& warning : warnings.messages()) all.push_back(warning.sentence());
  return all;
}

using Said = std::vector<std::string>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(RainGrowth, adds_what_a_table_lacks) {
  EarlierRain there = earlier("time,A\n2020,1.235\n2021,\n");
  RainGrowth growth("r.csv", "step", &there, 3);
  EXPECT_FALSE(growth.lacks("2020", std::vector{1.2346}));
  EXPECT_FALSE(growth.lacks("2021", std::vector{none}));
  EXPECT_FALSE(growth.changes());
  EXPECT_TRUE(growth.lacks("2022", std::vector{2.0}));
  EXPECT_TRUE(growth.changes());
  EXPECT_EQ(said(growth), Said{"r.csv: 1 step added, 2 were there"});
}

TEST(RainGrowth, adds_all_where_there_is_no_table) {
  RainGrowth growth("r.csv", "period", nullptr, 3);
  EXPECT_TRUE(growth.lacks("2020", std::vector{1.0}));
  EXPECT_TRUE(growth.lacks("2021", std::vector{1.0}));
  EXPECT_EQ(said(growth), Said{"r.csv: 2 periods added, none were there"});
}

TEST(RainGrowth, warns_of_other_values_and_of_steps_between) {
  EarlierRain there = earlier("time,A\n2020,1.000\n2021,2.000\n2023,3.000\n");
  RainGrowth growth("r.csv", "step", &there, 3);
  EXPECT_FALSE(growth.lacks("2020", std::vector{1.002}));
  EXPECT_FALSE(growth.lacks("2021", std::vector{none}));
  EXPECT_TRUE(growth.lacks("2022", std::vector{1.0}));
  EXPECT_EQ(said(growth),
            (Said{"r.csv: 1 step added, 3 were there",
                  "r.csv: 2 steps that are there have other values in this run, the first is "
                  "'2020': they stay as they are",
                  "r.csv: 1 step added lies before the last that was there, '2022': the table is "
                  "not in the order of time"}));
}

TEST(RainGrowth, tells_of_other_values_before_the_end_once) {
  EarlierRain there = earlier("time,A\n2020,1.000\n2021,2.000\n");
  RainGrowth growth("r.csv", "step", &there, 3);
  Warnings so_far;
  growth.tell_so_far(so_far);
  growth.lacks("2020", std::vector{3.0});
  growth.tell_so_far(so_far);
  growth.tell_so_far(so_far);
  ASSERT_EQ(so_far.messages().size(), 1U);
  EXPECT_EQ(said(growth).size(), 1U);
  growth.lacks("2021", std::vector{3.0});
  EXPECT_EQ(said(growth).size(), 2U);
}

TEST(RainGrowth, takes_the_value_that_is_there_for_the_first_step_of_counters) {
  EarlierRain there = earlier("time,A\n2020,\n2021,2.000\n");
  RainGrowth growth("r.csv", "step", &there, 3);
  growth.is_of_counters();
  EXPECT_FALSE(growth.lacks("2021", std::vector{none}));
  EXPECT_TRUE(growth.lacks("2022", std::vector{1.0}));
  EXPECT_EQ(said(growth), Said{"r.csv: 1 step added, 2 were there"});
  RainGrowth silent_later("r.csv", "step", &there, 3);
  silent_later.is_of_counters();
  EXPECT_FALSE(silent_later.lacks("2020", std::vector{none}));
  EXPECT_FALSE(silent_later.lacks("2021", std::vector{none}));
  EXPECT_EQ(said(silent_later).size(), 2U) << "another value, for it is no first step";
}

TEST(RainGrowth, warns_of_a_first_step_of_counters_that_it_adds_empty) {
  EarlierRain there = earlier("time,A\n2020,\n2021,2.000\n");
  RainGrowth growth("r.csv", "step", &there, 3);
  growth.is_of_counters();
  EXPECT_TRUE(growth.lacks("2022", std::vector{none}));
  EXPECT_TRUE(growth.lacks("2023", std::vector{1.0}));
  Warnings so_far;
  growth.tell_so_far(so_far);
  ASSERT_EQ(so_far.messages().size(), 1U);
  EXPECT_EQ(so_far.messages()[0].sentence(),
            "r.csv: the step '2022' is added without a value: with it the counters of this run "
            "begin, and nothing tells what they read in the step before");
  EXPECT_EQ(said(growth), Said{"r.csv: 2 steps added, 2 were there"});
  RainGrowth anew("r.csv", "step", nullptr, 3);
  anew.is_of_counters();
  EXPECT_TRUE(anew.lacks("2022", std::vector{none}));
  EXPECT_EQ(said(anew), Said{"r.csv: 1 step added, none were there"});
}

TEST(RainGrowth, refuses_times_of_another_kind) {
  EarlierRain there = earlier("time,A\n2020-01-01,1\n");
  for (const char* time : {"2020-01", "2020-01-01T00:00", "01.02.2020"}) {
    RainGrowth growth("r.csv", "step", &there, 3);
    EXPECT_TRUE(contains(complaint_of([&] { growth.lacks(time, std::vector{1.0}); }),
                         std::string("its times are written as '2020-01-01', and those of this "
                                     "run as '") +
                             time));
  }
}

TEST(RainGrowth, writes_a_step_anew_that_was_cut_off) {
  EarlierRain there = earlier("time,A\n2020,1\n2021,2.1");
  RainGrowth comes("r.csv", "step", &there, 3);
  EXPECT_TRUE(comes.changes());
  EXPECT_TRUE(comes.lacks("2021", std::vector{2.125}));
  EXPECT_EQ(said(comes), (Said{"r.csv: 1 step added, 1 was there",
                               "r.csv: its last line has no line end, '2021,2.1': it is taken off, "
                               "and written anew"}));
  RainGrowth does_not("r.csv", "step", &there, 3);
  EXPECT_TRUE(contains(complaint_of([&] { said(does_not); }), "does not have its step"));
  Warnings at_once;
  does_not.tell_cut_taken_off(at_once);
  EXPECT_EQ(at_once.messages().at(0).sentence(),
            "r.csv: its last line has no line end, '2021,2.1': it is taken off, and added again if "
            "it comes");
  EXPECT_EQ(said(does_not), Said{"r.csv: no steps added, 1 was there"});
  EarlierRain surely = earlier("time,A\n2020,1\n2021");
  RainGrowth nothing("r.csv", "step", &surely, 3);
  EXPECT_EQ(said(nothing).size(), 2U);
}

TEST(RainGrowth, knows_the_columns_of_every_table) {
  const std::vector<Basin> basins = {{"A", {}, {}}, {"B", {}, {}}};
  RainFormat format;
  EXPECT_EQ(rain_shape(basins, format, false).header, "time,A,B\n");
  EXPECT_EQ(rain_shape(basins, format, false).values, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(rain_shape(basins, format, true).header, "time,A,A_missing,B,B_missing\n");
  EXPECT_EQ(rain_shape(basins, format, true).values, (std::vector<std::size_t>{1, 3}));
  format.errors = true;
  EXPECT_EQ(rain_shape(basins, format, false).values, (std::vector<std::size_t>{1, 2, 3, 4}));
  format.rows_for_basins = true;
  EXPECT_EQ(rain_shape(basins, format, false).values, (std::vector<std::size_t>{2, 5}));
  EXPECT_EQ(rain_shape(basins, format, false).rows, 2U);
  format.errors = false;
  format.methods = {"idw", "natural"};
  EXPECT_EQ(rain_shape(basins, format, false).header,
            "time,basin,method,rainfall,gauges,coverage\n");
  EXPECT_EQ(rain_shape(basins, format, false).values, std::vector<std::size_t>{3});
  EXPECT_EQ(rain_shape(basins, format, false).rows, 4U);
  EXPECT_EQ(rain_shape(basins, format, true).header, "time,basin,method,rainfall,missing\n");
}

}  // namespace
}  // namespace thiessen
