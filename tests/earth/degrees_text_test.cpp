#include "earth/degrees_text.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

using Axis = DegreesText::Axis;

void expect_angle(const char* text, double degrees, Axis axis) {
  const auto angle = degrees_text(text);
  ASSERT_TRUE(angle) << text;
  EXPECT_DOUBLE_EQ(angle->degrees, degrees) << text;
  EXPECT_EQ(angle->axis, axis) << text;
}

// 47 degrees, 30 minutes and 15 seconds are 47 + 30 / 60 + 15 / 3600 = 47.504166...
TEST(DegreesText, is_written_in_many_ways) {
  constexpr double angle = 47.0 + 30.0 / 60 + 15.0 / 3600;
  for (const char* text : {"47°30'15\"N", "47d30'15\"N", "47:30:15N", "N47:30:15", "47 30 15 N",
                           "47° 30′ 15″ N", "47-30-15N", "47 : 30 : 15 N"})
    expect_angle(text, angle, Axis::latitude);
  expect_angle("47 30 15", angle, Axis::unsaid);
  expect_angle("-47:30:15", -angle, Axis::unsaid);
  expect_angle("- 47 30 15", -angle, Axis::unsaid);
  expect_angle("47°30.25'", angle, Axis::unsaid);
}

TEST(DegreesText, is_negative_in_the_south_and_the_west) {
  expect_angle("5°30'S", -5.5, Axis::latitude);
  expect_angle("0 30 W", -0.5, Axis::longitude);
}

TEST(DegreesText, is_nothing_else) {
  for (const char* text : {"", "N", "abc", "47:60:00N", "47:30:75N", "10+5", "2020-13-61",
                           "1:2:3:4", "W47 30 15N", "1e", "10:30w", "5°30'O", "'"})
    EXPECT_FALSE(degrees_text(text)) << text;
}

}  // namespace
}  // namespace thiessen
