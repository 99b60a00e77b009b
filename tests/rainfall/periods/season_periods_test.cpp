#include "rainfall/periods/season_periods.h"

#include <gtest/gtest.h>

#include "rainfall/periods/names_of_periods.h"

namespace thiessen {
namespace {

TEST(SeasonPeriods, have_the_year_of_their_january) {
  const SeasonPeriods seasons(0);
  EXPECT_EQ(period_of(seasons, "2013-11"), "2013-SON");
  EXPECT_EQ(period_of(seasons, "2013-12"), "2014-DJF");
  EXPECT_EQ(period_of(seasons, "2014-02-28"), "2014-DJF");
  EXPECT_EQ(period_of(seasons, "2014-03"), "2014-MAM");
  EXPECT_EQ(period_of(seasons, "2014-05-31"), "2014-MAM");
  EXPECT_EQ(period_of(seasons, "2014-06"), "2014-JJA");
  EXPECT_EQ(period_of(seasons, "2014-09"), "2014-SON");
  EXPECT_EQ(period_of(seasons, "0001-01"), "0001-DJF");
}

TEST(SeasonPeriods, begin_in_december_march_june_and_september) {
  EXPECT_EQ(begin_of(SeasonPeriods(0), "2016-02-29"), "2015-12");
  EXPECT_EQ(begin_of(SeasonPeriods(3'600), "2016-06-01T00:59"), "2016-03-01T01:00");
}

TEST(SeasonPeriods, law_1_follow_each_other) {
  EXPECT_EQ(first_gap(SeasonPeriods(0), "1800-01", "2200-01"), "");
}

}  // namespace
}  // namespace thiessen
