#include "rainfall/periods/week_periods.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <utility>

#include "rainfall/periods/names_of_periods.h"

namespace thiessen {
namespace {

// By Python's datetime.date.isocalendar.
TEST(WeekPeriods, have_the_year_of_their_thursday) {
  constexpr std::array<std::pair<const char*, const char*>, 16> known{{{"1600-01-01", "1599-W52"},
                                                                       {"1899-01-01", "1898-W52"},
                                                                       {"1900-12-31", "1901-W01"},
                                                                       {"1999-01-01", "1998-W53"},
                                                                       {"2000-01-01", "1999-W52"},
                                                                       {"2000-12-31", "2000-W52"},
                                                                       {"2004-12-31", "2004-W53"},
                                                                       {"2005-01-01", "2004-W53"},
                                                                       {"2008-12-31", "2009-W01"},
                                                                       {"2010-01-01", "2009-W53"},
                                                                       {"2014-01-27", "2014-W05"},
                                                                       {"2014-02-02", "2014-W05"},
                                                                       {"2016-01-01", "2015-W53"},
                                                                       {"2020-12-31", "2020-W53"},
                                                                       {"2021-12-31", "2021-W52"},
                                                                       {"9998-12-31", "9998-W53"}}};
  for (const auto& [date, week] : known) EXPECT_EQ(period_of(WeekPeriods(0), date), week) << date;
}

TEST(WeekPeriods, begin_on_mondays) {
  EXPECT_EQ(begin_of(WeekPeriods(0), "2014-02-02T23:59"), "2014-01-27");
  EXPECT_EQ(begin_of(WeekPeriods(9 * 3'600), "2014-01-27T08:59"), "2014-01-20T09:00");
}

// The calendar repeats itself after 400 years, which are 20,871 weeks; 71 of the years have 53.
TEST(WeekPeriods, law_1_are_20871_in_400_years_of_which_71_have_53) {
  const WeekPeriods weeks(0);
  const std::int64_t first = weeks.number_of(parse_iso_time("1970-01-01").time);
  const std::int64_t last = weeks.number_of(parse_iso_time("2370-01-01").time);
  EXPECT_EQ(last - first, 20'871);
  int long_years = 0;
  for (std::int64_t week = first; week < last; ++week)
    long_years += weeks.name_of(week, std::nullopt).ends_with("-W53") ? 1 : 0;
  EXPECT_EQ(long_years, 71);
}

TEST(WeekPeriods, law_2_follow_each_other) {
  EXPECT_EQ(first_gap(WeekPeriods(0), "1800-01-01", "2200-01-01"), "");
}

}  // namespace
}  // namespace thiessen
