#include "readings/readings_times.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen {
namespace {

TEST(ReadingsTimes, are_numbered_as_they_first_come) {
  ReadingsTimes times;
  const auto enter = [&](const char* time, std::size_t line) { return times.enter(time, line); };
  EXPECT_EQ(enter("b", 2).step, 0u);
  EXPECT_EQ(enter("a", 3).step, 1u);
  EXPECT_EQ(enter("b", 4).step, 0u);
  EXPECT_FALSE(enter("b", 5).fresh);
  EXPECT_TRUE(enter("", 6).fresh);
  EXPECT_EQ(times.size(), 3u);
  EXPECT_EQ(times.line(0), 2u);
  EXPECT_EQ(times.text(1), "a");
  EXPECT_EQ(times.text(2), "");
}

TEST(ReadingsTimes, in_sorting_order_are_found_when_one_comes_again) {
  ReadingsTimes times;
  for (std::size_t i = 0; i < 1000; ++i) {
    ASSERT_TRUE(times.enter(std::to_string(1000 + i), i).fresh);
  }
  EXPECT_FALSE(times.enter("1000", 0).fresh);
  EXPECT_EQ(times.enter("1500", 0).step, 500u);
  EXPECT_FALSE(times.enter("1999", 0).fresh);
  EXPECT_TRUE(times.enter("2000", 7).fresh) << "sorted again, but the table goes on";
  EXPECT_FALSE(times.enter("1000", 0).fresh);
  EXPECT_EQ(times.enter("2000", 0).step, 1000u);
}

TEST(ReadingsTimes, are_found_again_among_many) {
  ReadingsTimes times;
  for (std::size_t i = 0; i < 100'000; ++i) {  // in sorting order up to 9, and no longer from 10 on
    ASSERT_TRUE(times.enter("2020-" + std::to_string(i), i).fresh);
  }
  for (std::size_t i = 0; i < 100'000; ++i) {
    const auto entered = times.enter("2020-" + std::to_string(i), 0);
    ASSERT_FALSE(entered.fresh);
    ASSERT_EQ(entered.step, i);
    ASSERT_EQ(times.line(i), i);
  }
}

}  // namespace
}  // namespace thiessen
