#include "rainfall/periods/periods_of_days.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

// 2000-02-29 is day 11016, and 1600-03-01 lies 400 years of 146,097 days before 2000-03-01.
TEST(PeriodsOfDays, know_the_months_of_days) {
  EXPECT_EQ(month_of_day(11'016), 12 * 2000 + 1);
  EXPECT_EQ(month_of_day(11'017), 12 * 2000 + 2);
  EXPECT_EQ(month_of_day(11'017 - 146'097), 12 * 1600 + 2);
  EXPECT_EQ(first_day_of_month(12 * 2000 + 2), 11'017);
  EXPECT_EQ(first_day_of_month(12 * 1970), 0);
  EXPECT_EQ(first_day_of_month(12 * 1969 + 11), -31);
}

}  // namespace
}  // namespace thiessen
