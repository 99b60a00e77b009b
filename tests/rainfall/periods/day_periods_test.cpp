#include "rainfall/periods/day_periods.h"

#include <gtest/gtest.h>

#include "rainfall/periods/names_of_periods.h"

namespace thiessen {
namespace {

constexpr std::int64_t nine = 9 * 3'600;

TEST(DayPeriods, are_called_by_their_date) {
  const DayPeriods days(0);
  EXPECT_EQ(period_of(days, "2016-02-29"), "2016-02-29");
  EXPECT_EQ(period_of(days, "2016-02-29T23:59:59"), "2016-02-29");
  EXPECT_EQ(period_of(days, "1969-12-31T00:00"), "1969-12-31");
  EXPECT_EQ(days.precision(), TimePrecision::day);
}

TEST(DayPeriods, hold_the_midnight_that_is_written_as_their_end) {
  EXPECT_EQ(period_of(DayPeriods(0), "2013-08-31T24:00"), "2013-08-31");
  EXPECT_EQ(period_of(DayPeriods(nine), "2013-08-31T24:00"), "2013-08-31");
}

TEST(DayPeriods, that_begin_at_nine_are_called_by_the_date_on_which_they_begin) {
  const DayPeriods days(nine);
  EXPECT_EQ(period_of(days, "2014-03-01T08:59"), "2014-02-28");
  EXPECT_EQ(period_of(days, "2014-03-01T09:00"), "2014-03-01");
  EXPECT_EQ(begin_of(days, "2014-03-01T08:59"), "2014-02-28T09:00");
  EXPECT_EQ(days.precision(), TimePrecision::instant);
}

TEST(DayPeriods, law_1_are_those_of_the_clock_as_it_is_written) {
  const DayPeriods days(0);
  EXPECT_EQ(period_of(days, "2019-10-27T02:30+02:00"), "2019-10-27");
  EXPECT_EQ(period_of(days, "2019-10-27T23:30-11:00"), "2019-10-27");
}

TEST(DayPeriods, law_2_follow_each_other) {
  EXPECT_EQ(first_gap(DayPeriods(0), "1890-01-01", "2110-01-01"), "");
  EXPECT_EQ(first_gap(DayPeriods(nine), "1960-01-01", "1980-01-01"), "");
}

}  // namespace
}  // namespace thiessen
