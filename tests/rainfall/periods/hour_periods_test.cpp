#include "rainfall/periods/hour_periods.h"

#include <gtest/gtest.h>

#include "rainfall/periods/names_of_periods.h"

namespace thiessen {
namespace {

constexpr std::int64_t hour = 3'600;

TEST(HourPeriods, are_called_by_the_time_at_which_they_begin) {
  EXPECT_EQ(period_of(HourPeriods(1, 0, 0), "2014-02-01T06:59"), "2014-02-01T06:00");
  EXPECT_EQ(period_of(HourPeriods(6, 0, 0), "2014-02-01T11:00"), "2014-02-01T06:00");
  EXPECT_EQ(period_of(HourPeriods(6, 0, 0), "2014-02-01T24:00"), "2014-02-02T00:00");
  EXPECT_EQ(period_of(HourPeriods(24, 0, 0), "2014-02-01T11:00"), "2014-02-01T00:00");
}

TEST(HourPeriods, are_counted_from_where_days_begin) {
  const HourPeriods sixes(6, 9 * hour, 0);
  EXPECT_EQ(period_of(sixes, "2014-02-01T08:59"), "2014-02-01T03:00");
  EXPECT_EQ(period_of(sixes, "2014-02-01T02:59"), "2014-01-31T21:00");
  EXPECT_EQ(period_of(HourPeriods(1, 30 * 60, 0), "2014-02-01T06:29"), "2014-02-01T05:30");
}

// 2014-02-01 is day 16102: by threes from 1970 its remainder is 1, so that one began the day
// before.
TEST(HourPeriods, that_make_up_no_day_are_counted_on_from_a_first_day) {
  EXPECT_EQ(period_of(HourPeriods(72, 0, 0), "2014-02-01T06:00"), "2014-01-31T00:00");
  EXPECT_EQ(period_of(HourPeriods(72, 0, 16'102), "2014-02-03T23:00"), "2014-02-01T00:00");
  EXPECT_EQ(period_of(HourPeriods(72, 0, 16'102), "2014-01-31T23:00"), "2014-01-29T00:00");
  EXPECT_EQ(period_of(HourPeriods(5, 0, 16'102), "2014-02-02T00:00"), "2014-02-01T20:00");
}

TEST(HourPeriods, law_1_single_hours_that_are_written_twice_are_two) {
  const HourPeriods hours(1, 0, 0);
  EXPECT_EQ(period_of(hours, "2019-10-27T02:45+02:00"), "2019-10-27T02:00+02:00");
  EXPECT_EQ(period_of(hours, "2019-10-27T02:00+01:00"), "2019-10-27T02:00+01:00");
  EXPECT_EQ(hours.number_of(parse_iso_time("2019-10-27T02:45+02:00").time) + 1,
            hours.number_of(parse_iso_time("2019-10-27T02:00+01:00").time));
  EXPECT_EQ(period_of(hours, "2019-10-27T02:45Z"), "2019-10-27T02:00Z");
  EXPECT_EQ(period_of(hours, "2019-10-27T02:45+05:30"), "2019-10-27T02:00+05:30");
  EXPECT_EQ(period_of(hours, "2019-10-27T02:45-03:30"), "2019-10-27T02:00-03:30");
}

TEST(HourPeriods, law_2_others_are_those_of_the_clock) {
  const HourPeriods sixes(6, 0, 0);
  EXPECT_EQ(sixes.number_of(parse_iso_time("2019-10-27T02:45+02:00").time),
            sixes.number_of(parse_iso_time("2019-10-27T02:00+01:00").time));
  EXPECT_EQ(period_of(sixes, "2019-10-27T07:00+01:00"), "2019-10-27T06:00+01:00");
}

TEST(HourPeriods, law_3_follow_each_other) {
  EXPECT_EQ(first_gap(HourPeriods(1, 0, 0), "1969-12-01T00:00", "1970-02-01T00:00"), "");
  EXPECT_EQ(first_gap(HourPeriods(7, 3 * hour, 5), "1969-12-01T00:00", "1971-02-01T00:00"), "");
}

}  // namespace
}  // namespace thiessen
