#include "rainfall/periods/every.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(Every, wants_times_that_say_the_period) {
  EXPECT_EQ(Every(PeriodUnit::hours).least_precision(), TimePrecision::instant);
  EXPECT_EQ(Every(PeriodUnit::week).least_precision(), TimePrecision::day);
  EXPECT_EQ(Every(PeriodUnit::storm).least_precision(), TimePrecision::day);
  EXPECT_EQ(Every(PeriodUnit::season).least_precision(), TimePrecision::month);
  Every year = PeriodUnit::year;
  EXPECT_EQ(year.least_precision(), TimePrecision::year);
  year.year_start = 10;
  EXPECT_EQ(year.least_precision(), TimePrecision::month);
  year.day_start = 60;
  EXPECT_EQ(year.least_precision(), TimePrecision::instant);
}

}  // namespace
}  // namespace thiessen
