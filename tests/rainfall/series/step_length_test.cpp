#include "rainfall/series/step_length.h"

#include <gtest/gtest.h>

#include <string_view>

namespace thiessen {
namespace {

IsoTime time_of(std::string_view text) {
  const ParsedTime parsed = parse_iso_time(text);
  EXPECT_TRUE(parsed) << text;
  return parsed.time;
}

TEST(StepLength, is_said_in_the_largest_unit_of_which_it_is_a_whole_number) {
  EXPECT_EQ(text_of({12, 0}), "1 year");
  EXPECT_EQ(text_of({24, 0}), "2 years");
  EXPECT_EQ(text_of({1, 0}), "1 month");
  EXPECT_EQ(text_of({18, 0}), "18 months");
  EXPECT_EQ(text_of({0, 86'400}), "1 day");
  EXPECT_EQ(text_of({0, 7 * 86'400}), "7 days");
  EXPECT_EQ(text_of({0, 3'600}), "1 hour");
  EXPECT_EQ(text_of({0, 36 * 3'600}), "36 hours");
  EXPECT_EQ(text_of({0, 600}), "10 minutes");
  EXPECT_EQ(text_of({0, 3'660}), "61 minutes");
  EXPECT_EQ(text_of({0, 61}), "61 seconds");
  EXPECT_EQ(text_of({0, 1}), "1 second");
}

TEST(StepLength, of_a_day_or_less_is_told_from_longer_ones) {
  EXPECT_TRUE((StepLength{0, 86'400}).is_a_day_or_less());
  EXPECT_FALSE((StepLength{0, 86'401}).is_a_day_or_less());
  EXPECT_FALSE((StepLength{1, 0}).is_a_day_or_less());
}

TEST(MonthNumber, law_1_goes_on_by_one_over_the_end_of_a_year) {
  EXPECT_EQ(month_number(time_of("0000-01")), 0);
  EXPECT_EQ(month_number(time_of("2013-08")), 2013 * 12 + 7);
  EXPECT_EQ(month_number(time_of("2014-01")), month_number(time_of("2013-12-31T23:59")) + 1);
}

bool are_alike(std::string_view a, std::string_view b) {
  EXPECT_EQ(stand_alike_in_months(time_of(a), time_of(b)),
            stand_alike_in_months(time_of(b), time_of(a)));
  return stand_alike_in_months(time_of(a), time_of(b));
}

TEST(StandAlikeInMonths, law_2_at_the_same_day_and_clock_or_both_on_the_last_day) {
  EXPECT_TRUE(are_alike("2013-08-15", "2013-09-15"));
  EXPECT_FALSE(are_alike("2013-08-15", "2013-09-16"));
  EXPECT_TRUE(are_alike("2013-01-31", "2013-02-28"));
  EXPECT_TRUE(are_alike("2013-01-31", "2013-04-30"));
  EXPECT_TRUE(are_alike("2012-02-29", "2013-02-28"));
  EXPECT_FALSE(are_alike("2012-02-28", "2012-03-31"));
  EXPECT_FALSE(are_alike("2013-08-15T06:00", "2013-09-15T07:00"));
  EXPECT_FALSE(are_alike("2013-01-31T06:00", "2013-02-28T06:00:00.5"));
}

// A century is a leap year only every four hundred years.
TEST(StandAlikeInMonths, law_3_the_last_day_of_february_is_the_calendar_s) {
  EXPECT_TRUE(are_alike("2000-02-29", "2000-03-31"));
  EXPECT_FALSE(are_alike("2000-02-28", "2000-03-31"));
  EXPECT_TRUE(are_alike("1900-02-28", "1900-03-31"));
}

}  // namespace
}  // namespace thiessen
