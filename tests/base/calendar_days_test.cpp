#include "base/calendar_days.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(CalendarDays, quotients_are_rounded_down) {
  EXPECT_EQ(floor_quotient(7, 3), 2);
  EXPECT_EQ(floor_quotient(6, 3), 2);
  EXPECT_EQ(floor_quotient(-1, 3), -1);
  EXPECT_EQ(floor_quotient(-3, 3), -1);
  EXPECT_EQ(floor_quotient(-4, 3), -2);
}

// 2000-02-29 is day 11016, and 1600-03-01 lies 400 years of 146,097 days before 2000-03-01.
TEST(CalendarDays, know_the_months_of_days) {
  EXPECT_EQ(month_of_day(11'016), 12 * 2000 + 1);
  EXPECT_EQ(month_of_day(11'017), 12 * 2000 + 2);
  EXPECT_EQ(month_of_day(11'017 - 146'097), 12 * 1600 + 2);
  EXPECT_EQ(first_day_of_month(12 * 2000 + 2), 11'017);
  EXPECT_EQ(first_day_of_month(12 * 1970), 0);
  EXPECT_EQ(first_day_of_month(12 * 1969 + 11), -31);
}

TEST(CalendarDays, know_how_long_months_are) {
  EXPECT_EQ(days_in_month(12 * 2012 + 1), 29);
  EXPECT_EQ(days_in_month(12 * 2013 + 1), 28);
  EXPECT_EQ(days_in_month(12 * 1900 + 1), 28);
  EXPECT_EQ(days_in_month(12 * 1969 + 11), 31);
}

}  // namespace
}  // namespace thiessen
