// The step that a series keeps to, and where it lacks one.
#include "readings/steps/usual_step.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen {
namespace {

IsoTime time_of(const std::string& text) {
  return parse_iso_time(text).time;
}

UsualStep of(const std::vector<std::string>& times) {
  UsualStep step;
  for (const std::string& time : times) step.note(time_of(time));
  return step;
}

TEST(UsualStep, lacks_between_times_two_of_it_apart) {
  const UsualStep hours = of({"2020-01-01T00:00", "2020-01-01T01:00", "2020-01-01T05:00"});
  EXPECT_TRUE(hours.lacks_between(time_of("2020-01-01T01:00"), time_of("2020-01-01T05:00")));
  EXPECT_TRUE(hours.lacks_between(time_of("2020-01-01T01:00"), time_of("2020-01-01T03:00")));
  EXPECT_FALSE(hours.lacks_between(time_of("2020-01-01T01:00"), time_of("2020-01-01T02:00")));
  EXPECT_FALSE(hours.lacks_between(time_of("2020-01-01T01:00"), time_of("2020-01-01T02:59")));
}

TEST(UsualStep, is_told_by_what_follows_a_gap_at_the_beginning) {
  const UsualStep hours = of({"2020-01-01T00:00", "2020-01-01T05:00", "2020-01-01T06:00"});
  EXPECT_TRUE(hours.lacks_between(time_of("2020-01-01T00:00"), time_of("2020-01-01T05:00")));
}

TEST(UsualStep, is_one_of_the_calendar_where_that_holds) {
  const UsualStep months = of({"2020-01", "2020-02", "2020-03"});
  EXPECT_FALSE(months.lacks_between(time_of("2020-07"), time_of("2020-08")));
  EXPECT_TRUE(months.lacks_between(time_of("2020-07"), time_of("2020-09")));
  const UsualStep years = of({"2019", "2020", "2021"});
  EXPECT_FALSE(years.lacks_between(time_of("2021"), time_of("2022")));
  EXPECT_TRUE(years.lacks_between(time_of("2021"), time_of("2023")));
}

TEST(UsualStep, is_none_where_steps_are_as_they_come) {
  const UsualStep tips = of({"2020-01-01T00:03", "2020-01-01T00:17", "2020-01-01T00:18",
                             "2020-01-01T04:00", "2020-01-01T04:07"});
  EXPECT_FALSE(tips.lacks_between(time_of("2020-01-01T00:18"), time_of("2020-01-01T04:00")));
  EXPECT_FALSE(
      of({"2020"}).lacks_between(time_of("2020-01-01T00:18"), time_of("2020-01-01T04:00")));
}

}  // namespace
}  // namespace thiessen
