#include "cli/outputs/held_rain.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen::cli {
namespace {

TEST(HeldRain, keeps_steps_in_their_order) {
  HeldRain held;
  held.add("1", std::vector<double>{1, 2});
  held.add("2", std::vector<double>{3, 4});
  ASSERT_FALSE(held.is_too_long());
  const auto rain = held.take();
  ASSERT_TRUE(rain);
  EXPECT_EQ(rain->times, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(rain->values, (std::vector<double>{1, 2, 3, 4}));
}

TEST(HeldRain, lets_a_series_go_that_has_more_than_a_million_values) {
  HeldRain held;
  const std::vector<double> step(HeldRain::most_values / 4);
  for (int i = 0; i < 4; ++i) held.add("t", step);
  EXPECT_FALSE(held.is_too_long());
  held.add("t", std::vector<double>{1});
  EXPECT_TRUE(held.is_too_long());
  held.add("t", std::vector<double>{1});
  EXPECT_FALSE(held.take());
}

}  // namespace
}  // namespace thiessen::cli
