#include "rainfall/series/step_intervals.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen {
namespace {

StepIntervals intervals_of(const std::vector<std::string>& times) {
  StepIntervals intervals;
  for (const std::string& time : times) intervals.note(parse_iso_time(time));
  return intervals;
}

std::string step_of(const std::vector<std::string>& times) {
  const auto step = intervals_of(times).step();
  return step ? text_of(*step) : "none";
}

TEST(StepIntervals, law_1_TheStepIsTheLongestOfWhichNineInTenAreMultiples) {
  EXPECT_EQ(step_of({"2019-01-01", "2019-01-02", "2019-01-04", "2019-01-07"}), "1 day");
  EXPECT_EQ(step_of({"2019-01-01", "2019-01-03", "2019-01-05", "2019-01-09"}), "2 days");
  EXPECT_EQ(step_of({"2019-01-01T00:00", "2019-01-01T00:10", "2019-01-01T00:30"}), "10 minutes");
  std::vector<std::string> nine_in_ten{"2019-01-01T00:00"};
  for (int hour = 1; hour <= 9; ++hour)
    nine_in_ten.push_back("2019-01-01T0" + std::to_string(hour) + ":00");
  nine_in_ten.push_back("2019-01-01T09:59");
  EXPECT_EQ(step_of(nine_in_ten), "1 hour");
  nine_in_ten.push_back("2019-01-01T10:30");
  EXPECT_EQ(step_of(nine_in_ten), "none");
}

TEST(StepIntervals, law_2_MonthsAndYearsAreTheCalendars) {
  EXPECT_EQ(step_of({"2019-01", "2019-02", "2019-03"}), "1 month");
  EXPECT_EQ(step_of({"2019-01-31", "2019-02-28", "2019-03-31", "2019-04-30"}), "1 month");
  EXPECT_EQ(step_of({"2015-07-01", "2016-07-01", "2017-07-01"}), "1 year");
  EXPECT_EQ(step_of({"1999", "2000", "2002"}), "1 year");
  EXPECT_EQ(step_of({"2019-01-15", "2019-04-15", "2019-10-15"}), "3 months");
}

TEST(StepIntervals, law_3_TheStepDoesNotDependOnTheDirectionOfTime) {
  EXPECT_EQ(step_of({"2019-01-07", "2019-01-04", "2019-01-02", "2019-01-01"}), "1 day");
}

TEST(StepIntervals, goes_by_moments_where_zones_are_written) {
  EXPECT_EQ(step_of({"2019-03-31T00:00+01:00", "2019-03-31T01:00+01:00", "2019-03-31T03:00+02:00",
                     "2019-03-31T04:00+02:00"}),
            "1 hour");
}

TEST(StepIntervals, knows_no_step_of_labels_and_of_one_time) {
  EXPECT_EQ(step_of({"2019-01-01", "storm", "2019-01-02"}), "none");
  EXPECT_TRUE(intervals_of({"storm"}).has_labels());
  EXPECT_EQ(step_of({"2019-01-01"}), "none");
  EXPECT_EQ(step_of({}), "none");
}

TEST(StepIntervals, names_the_steps_that_lack) {
  const StepIntervals intervals =
      intervals_of({"2019-01-01", "2019-01-02", "2019-01-04", "2019-01-05", "2019-01-09"});
  const auto lacking = intervals.lacking(*intervals.step());
  ASSERT_TRUE(lacking);
  EXPECT_EQ(lacking->steps, 4u);
  EXPECT_EQ(lacking->first, "2019-01-03");
  EXPECT_EQ(lacking->last, "2019-01-08");
}

TEST(StepIntervals, names_months_that_lack_of_a_file_that_descends) {
  const StepIntervals intervals = intervals_of({"2019-12", "2019-09", "2019-08", "2019-07"});
  const auto lacking = intervals.lacking({1, 0});
  ASSERT_TRUE(lacking);
  EXPECT_EQ(lacking->steps, 2u);
  EXPECT_EQ(lacking->first, "2019-10");
  EXPECT_EQ(lacking->last, "2019-11");
}

TEST(StepIntervals, does_not_know_what_lacks_where_times_have_no_order) {
  const StepIntervals intervals = intervals_of({"2019-01-01", "2019-01-03", "2019-01-02"});
  EXPECT_FALSE(intervals.lacking({0, 86'400}));
}

}  // namespace
}  // namespace thiessen
