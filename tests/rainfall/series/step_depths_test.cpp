#include "rainfall/series/step_depths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string_view>

namespace thiessen {
namespace {

constexpr StepLength hour = {0, 3'600};
constexpr StepLength day = {0, 86'400};
constexpr StepLength month = {1, 0};
constexpr StepLength year = {12, 0};

double depth(StepLength rate, StepLength step, double value, std::string_view within,
             Stamp stamp = Stamp::begin) {
  return StepDepths(rate, step).of(value, parse_iso_time(within).time, stamp);
}

TEST(StepDepths, by_the_clock_are_the_share_of_the_time_of_the_rate) {
  EXPECT_EQ(depth(hour, {0, 900}, 4, "2020-01-01T00:00"), 1);
  EXPECT_EQ(depth(hour, day, 4, "2020-01-01"), 96);
  EXPECT_EQ(depth(day, hour, 24, "2020-01-01T07:00"), 1);
  EXPECT_EQ(depth(hour, hour, 0.1, "2020-01-01T07:00"), 0.1) << "every digit";
  EXPECT_TRUE(std::isnan(depth(hour, day, std::numeric_limits<double>::quiet_NaN(), "2020-01-01")));
}

TEST(StepDepths, of_months_are_those_of_the_calendar) {
  EXPECT_EQ(depth(day, month, 2, "2020-02"), 58);
  EXPECT_EQ(depth(day, month, 2, "2021-02-01"), 56);
  EXPECT_EQ(depth(day, year, 1, "2020"), 366);
  EXPECT_EQ(depth(day, {3, 0}, 1, "2021-01"), 90) << "31 + 28 + 31 days";
  EXPECT_EQ(depth(month, year, 5, "2021"), 60);
  EXPECT_EQ(depth(month, day, 58, "2020-02-07"), 2);
  EXPECT_EQ(depth(year, month, 12, "2021-02"), 1);
}

TEST(StepDepths, of_months_that_end_at_their_times_are_those_before) {
  EXPECT_EQ(depth(day, {3, 0}, 1, "2021-03-31T23:59:59", Stamp::end), 90);
}

}  // namespace
}  // namespace thiessen
