#include "readings/steps/spaced_readings.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>

namespace thiessen {
namespace {

SpacedReadings readings_at(std::initializer_list<std::int64_t> places) {
  SpacedReadings readings;
  for (const std::int64_t at : places) readings.note(at);
  return readings;
}

TEST(SpacedReadings, are_apart_by_what_divides_all_intervals_in_any_order) {
  EXPECT_EQ(readings_at({}).count(), 0U);
  EXPECT_EQ(readings_at({5}).apart(), 0);
  EXPECT_EQ(readings_at({-6, 0, 9}).apart(), 3);
  EXPECT_EQ(readings_at({9, -6, 0}).apart(), 3);
  EXPECT_EQ(readings_at({9, -6, 0}).last(), 0);
  EXPECT_EQ(readings_at({4, 4}).apart(), 0);
}

// Of 0, 2 ... 8 there are five places: three of them are more than half.
TEST(SpacedReadings, fill_their_steps_where_three_are_in_more_than_half_of_them) {
  EXPECT_TRUE(readings_at({0, 2, 8}).fill_their_steps());
  EXPECT_FALSE(readings_at({0, 2, 10}).fill_their_steps());
  EXPECT_TRUE(readings_at({10, 0, 2, 4}).fill_their_steps());
  EXPECT_FALSE(readings_at({0, 2}).fill_their_steps());
}

}  // namespace
}  // namespace thiessen
