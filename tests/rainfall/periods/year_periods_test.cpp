#include "rainfall/periods/year_periods.h"

#include <gtest/gtest.h>

#include "rainfall/periods/names_of_periods.h"

namespace thiessen {
namespace {

TEST(YearPeriods, are_those_of_the_calendar_where_they_begin_in_january) {
  const YearPeriods years(0, 1);
  EXPECT_EQ(period_of(years, "2013"), "2013");
  EXPECT_EQ(period_of(years, "2013-12-31"), "2013");
  EXPECT_EQ(begin_of(years, "2013-12-31"), "2013");
}

TEST(YearPeriods, that_begin_later_are_called_by_the_year_in_which_they_end) {
  EXPECT_EQ(period_of(YearPeriods(0, 10), "2013-09-30"), "2013");
  EXPECT_EQ(period_of(YearPeriods(0, 10), "2013-10-01"), "2014");
  EXPECT_EQ(period_of(YearPeriods(0, 10), "2014-09"), "2014");
  EXPECT_EQ(begin_of(YearPeriods(0, 10), "2014-09"), "2013-10");
  EXPECT_EQ(period_of(YearPeriods(0, 2), "2014-01"), "2014");
  EXPECT_EQ(period_of(YearPeriods(0, 2), "2014-02"), "2015");
  EXPECT_EQ(period_of(YearPeriods(0, 12), "2013-12"), "2014");
  EXPECT_EQ(period_of(YearPeriods(9 * 3'600, 10), "2013-10-01T08:00"), "2013");
}

TEST(YearPeriods, law_1_follow_each_other) {
  for (int month = 1; month <= 12; ++month)
    EXPECT_EQ(first_gap(YearPeriods(0, month), "1800", "2200"), "") << month;
}

}  // namespace
}  // namespace thiessen
