#include "rainfall/periods/period_calendar.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "rainfall/periods/names_of_periods.h"

namespace thiessen {
namespace {

TEST(PeriodCalendar, is_that_of_the_periods_that_are_wanted) {
  const auto name = [](Every every) {
    every.day_start = 32'400;
    every.year_start = 10;
    every.hours = 6;
    return period_of(*calendar_of(every), "2013-12-01T10:00");
  };
  EXPECT_EQ(name(PeriodUnit::hours), "2013-12-01T09:00");
  EXPECT_EQ(name(PeriodUnit::day), "2013-12-01");
  EXPECT_EQ(name(PeriodUnit::week), "2013-W48");
  EXPECT_EQ(name(PeriodUnit::month), "2013-12");
  EXPECT_EQ(name(PeriodUnit::season), "2014-DJF");
  EXPECT_EQ(name(PeriodUnit::year), "2014");
  EXPECT_THROW(calendar_of(PeriodUnit::storm), std::logic_error);
}

}  // namespace
}  // namespace thiessen
