#include "rainfall/periods/month_periods.h"

#include <gtest/gtest.h>

#include "rainfall/periods/names_of_periods.h"

namespace thiessen {
namespace {

TEST(MonthPeriods, are_those_of_the_calendar) {
  EXPECT_EQ(period_of(MonthPeriods(0), "2013-12"), "2013-12");
  EXPECT_EQ(period_of(MonthPeriods(0), "2013-12-31T23:59"), "2013-12");
  EXPECT_EQ(period_of(MonthPeriods(0), "2013-12-31T24:00"), "2013-12");
  EXPECT_EQ(MonthPeriods(0).precision(), TimePrecision::month);
}

TEST(MonthPeriods, begin_with_their_first_day) {
  EXPECT_EQ(period_of(MonthPeriods(9 * 3'600), "2014-01-01T08:00"), "2013-12");
  EXPECT_EQ(begin_of(MonthPeriods(9 * 3'600), "2014-01-01T08:00"), "2013-12-01T09:00");
}

TEST(MonthPeriods, law_1_follow_each_other) {
  EXPECT_EQ(first_gap(MonthPeriods(0), "1800-01", "2200-01"), "");
}

}  // namespace
}  // namespace thiessen
