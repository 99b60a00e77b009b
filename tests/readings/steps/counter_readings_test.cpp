#include "readings/steps/counter_readings.h"

#include <gtest/gtest.h>

#include <string>

#include "readings/table_readings.h"

namespace thiessen {
namespace {

using namespace table_readings;

Outcome counted_in(const std::string& table) {
  Reader reader({"A", "B"});
  reader.options.cumulative = true;
  return reader.read(table);
}

TEST(CounterReadings, are_what_fell_since_the_step_before_and_the_first_has_none) {
  expect_readings(counted_in("time,A,B\n1,5,0\n2,7,0\n3,7,2.5\n"), {"1", "2", "3"},
                  {{silent, silent}, {2, 0}, {0, 2.5}});
}

TEST(CounterReadings, go_on_from_what_a_counter_reads_after_a_reset) {
  const Outcome outcome = counted_in("time,A,B\n1,5,8\n2,1,0.5\n3,2,1\n");
  expect_readings(outcome, {"1", "2", "3"}, {{silent, silent}, {1, 0.5}, {1, 0.5}});
  EXPECT_EQ(outcome.warnings,
            Texts{"r.csv:3: the counter of station 'A' at '2' falls, the first of 2: taken for a "
                  "reset, so that what it reads then fell in that step (1 at most)"});
}

TEST(CounterReadings, leave_out_what_fell_in_more_than_one_step) {
  const Outcome outcome = counted_in("time,A,B\n1,5,5\n2,,\n3,9,5\n4,10,6\n");
  expect_readings(outcome, {"1", "2", "3", "4"},
                  {{silent, silent}, {silent, silent}, {silent, 0}, {1, 1}});
  EXPECT_EQ(
      outcome.warnings,
      Texts{"r.csv:4: the counter of station 'A' at '3' has no reading in the step before: what "
            "it has counted since fell in several steps and is left out (4 at most)"});
}

TEST(CounterReadings, leave_out_what_fell_over_steps_that_the_table_lacks) {
  const Outcome within = counted_in(
      "time,A,B\n2020-01-01 00:00,10,100\n2020-01-01 01:00,11,101\n2020-01-01 05:00,15,101\n"
      "2020-01-01 06:00,16,104\n");
  EXPECT_EQ(within.readings,
            (std::vector<std::vector<double>>{{silent, silent}, {1, 1}, {silent, 0}, {1, 3}}));
  EXPECT_EQ(within.warnings,
            Texts{"r.csv:4: the counter of station 'A' at '2020-01-01 05:00' has no reading in the "
                  "step before: what it has counted since fell in several steps and is left out (4 "
                  "at most)"});
  const Outcome at_the_beginning = counted_in(
      "time,A,B\n2020-01-01 01:00,11,101\n2020-01-01 05:00,15,101\n2020-01-01 06:00,16,104\n");
  EXPECT_EQ(at_the_beginning.readings,
            (std::vector<std::vector<double>>{{silent, silent}, {silent, 0}, {1, 3}}));
}

TEST(CounterReadings, take_steps_as_they_come_where_none_is_usual) {
  const Outcome tips = counted_in(
      "time,A,B\n2020-01-01 00:03,0,0\n2020-01-01 00:17,1,0\n2020-01-01 00:18,2,0\n"
      "2020-01-01 04:00,3,0\n2020-01-01 04:07,4,0\n");
  EXPECT_EQ(tips.readings,
            (std::vector<std::vector<double>>{{silent, silent}, {1, 0}, {1, 0}, {1, 0}, {1, 0}}));
}

TEST(CounterReadings, give_all_steps_before_a_row_that_cannot_be_read) {
  const Outcome outcome = counted_in("time,A,B\n1,5,0\n2,7,0\n3,x,0\n");
  EXPECT_EQ(outcome.times, (Texts{"1", "2"}));
  EXPECT_EQ(outcome.sentences.size(), 1U);
}

TEST(CounterReadings, want_the_order_of_time) {
  EXPECT_EQ(
      counted_in("time,A,B\n2020-01-02,5,5\n2020-01-01,4,4\n").sentences,
      Texts{"r.csv:3: time '2020-01-01' comes after '2020-01-02', and differences of counters "
            "are taken in the order of time"});
}

TEST(CounterReadings, are_never_too_large_by_themselves) {
  EXPECT_EQ(
      counted_in("time,A,B\n2020-01-01,50000,0\n2020-01-02,50001,0\n2020-01-03,50001,0\n").warnings,
      Texts{});
}

}  // namespace
}  // namespace thiessen
