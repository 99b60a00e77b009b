#include "readings/steps/monthly_readings.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen {
namespace {

MonthlyReadings readings_at(const std::vector<std::string>& times) {
  MonthlyReadings readings;
  for (const std::string& time : times) readings.note(CalendarPlace(parse_iso_time(time).time));
  return readings;
}

TEST(CalendarPlace, is_a_month_a_day_and_a_clock) {
  const CalendarPlace place(parse_iso_time("2020-02-29T01:02:03").time);
  EXPECT_EQ(place.day, 29);
  EXPECT_EQ(place.clock, 3723 * 1'000'000'000LL);
  EXPECT_TRUE(place.at_end);
  EXPECT_FALSE(CalendarPlace(parse_iso_time("2020-02-28").time).at_end);
  EXPECT_EQ(place.month - CalendarPlace(parse_iso_time("2019-12-01").time).month, 2);
}

TEST(MonthlyReadings, stand_alike_on_one_day_and_clock_or_on_the_last_day) {
  EXPECT_TRUE(readings_at({"2020-01-15", "2020-03-15", "2020-07-15"}).stand_alike());
  EXPECT_EQ(readings_at({"2020-01-15", "2020-03-15", "2020-07-15"}).months().apart(), 2);
  EXPECT_TRUE(readings_at({"2020-01-31", "2020-02-29", "2020-04-30"}).stand_alike());
  EXPECT_FALSE(readings_at({"2020-01-31", "2020-02-28"}).stand_alike());
  EXPECT_FALSE(readings_at({"2020-01-15", "2020-02-16"}).stand_alike());
  EXPECT_FALSE(readings_at({"2020-01-15T07:00", "2020-02-15T08:00"}).stand_alike());
}

TEST(MonthlyReadings, are_one_in_a_month_and_once_unlike_always_unlike) {
  EXPECT_FALSE(readings_at({"2020-01-15", "2020-01-15"}).stand_alike());
  EXPECT_FALSE(readings_at({"2020-01-15", "2020-02-16", "2020-03-15"}).stand_alike());
}

}  // namespace
}  // namespace thiessen
