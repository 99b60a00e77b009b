#include "map/plot/axis_ticks.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

std::vector<std::string> texts(const AxisTicks& axis) {
  std::vector<std::string> result;
  for (const AxisTicks::Tick& tick : axis.ticks) result.push_back(tick.text);
  return result;
}

TEST(AxisTicks, are_round_and_within_the_range) {
  const AxisTicks axis = axis_ticks(0, -3, 44, 8);
  EXPECT_EQ(texts(axis), (std::vector<std::string>{"0", "10", "20", "30", "40"}));
  EXPECT_EQ(axis.base, "");
  EXPECT_EQ(axis.ticks[2].at, 20);
}

TEST(AxisTicks, are_placed_from_the_origin) {
  const AxisTicks axis = axis_ticks(4000000, 10, 110, 4);
  EXPECT_EQ(axis.base, "");
  ASSERT_FALSE(axis.ticks.empty());
  EXPECT_EQ(axis.ticks[0].text, "4000050");
  EXPECT_EQ(axis.ticks[0].at, 50);
}

TEST(AxisTicks, of_a_narrow_range_are_counted_from_a_base) {
  const AxisTicks axis = axis_ticks(4000000, -1e-9, 1.1e-8, 6);
  EXPECT_EQ(axis.base, "4000000");
  EXPECT_EQ(axis.title('y'), "y \u2212 4000000");
  EXPECT_EQ(texts(axis), (std::vector<std::string>{"0", "2e-9", "4e-9", "6e-9", "8e-9", "1e-8"}));
  EXPECT_EQ(axis.ticks[1].at, 2e-9);
  const AxisTicks below = axis_ticks(-4000000, -1e-9, 1.1e-8, 6);
  EXPECT_EQ(below.title('x'), "x + 4000000");
}

TEST(AxisTicks, take_an_exponent_where_that_is_much_shorter) {
  EXPECT_EQ(texts(axis_ticks(0, 0, 2.4e-6, 3)), (std::vector<std::string>{"0", "1e-6", "2e-6"}));
  EXPECT_EQ(texts(axis_ticks(0, -1.3e-7, -1e-7, 3)).front(), "-1.3e-7");
  EXPECT_EQ(texts(axis_ticks(0, 0.001, 0.002, 2)).front(), "0.0010");
  EXPECT_EQ(texts(axis_ticks(0, 1.1e8, 1.7e8, 3)).front(), "120000000");
  EXPECT_EQ(texts(axis_ticks(0, 1.1e10, 1.7e10, 3)).front(), "1.2e10");
}

TEST(AxisTicks, have_as_many_decimals_as_each_other) {
  EXPECT_EQ(texts(axis_ticks(0, 1.75, 2.3, 4)), (std::vector<std::string>{"1.8", "2.0", "2.2"}));
  EXPECT_EQ(texts(axis_ticks(0, -0.55, 0.55, 4)), (std::vector<std::string>{"-0.5", "0.0", "0.5"}));
  EXPECT_EQ(texts(axis_ticks(4000000, 0.9, 2.2, 3)),
            (std::vector<std::string>{"1.0", "1.5", "2.0"}));
}

TEST(AxisTicks, of_any_range_are_few) {
  for (const double size : {1e-40, 1e-8, 1.0, 1e8, 1e60}) {
    for (const double origin : {0.0, size, 1e6 * size, 1e15 * size}) {
      const AxisTicks axis = axis_ticks(origin, -size / 3, size, 6);
      EXPECT_LE(axis.ticks.size(), 7u);
      EXPECT_GE(axis.ticks.size(), 2u) << size << " " << origin;
      for (const AxisTicks::Tick& tick : axis.ticks) {
        EXPECT_GE(tick.at, -size / 3 * 1.001);
        EXPECT_LE(tick.at, size * 1.001);
        EXPECT_LE(tick.text.size(), 12u) << tick.text;
      }
    }
  }
}

}  // namespace
}  // namespace thiessen
