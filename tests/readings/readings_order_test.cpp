#include "readings/readings_order.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace thiessen {
namespace {

bool all_follow(const std::vector<std::string>& times) {
  TimeOrder order;
  bool all = true;
  for (const std::string& time : times) all = order.follows(time);
  return all;
}

TEST(TimeOrder, holds_where_times_ascend_or_descend_as_text) {
  EXPECT_TRUE(all_follow({"2019-12-31T23:00", "2020-01-01T00:00", "2020-01-01T01:00Z"}));
  EXPECT_TRUE(all_follow({"c", "b", "a9", "a10", ""}));
  EXPECT_TRUE(all_follow({"0.45", "0.5", "0.75"}));
}

TEST(TimeOrder, holds_where_the_numbers_in_them_ascend_or_descend) {
  EXPECT_TRUE(all_follow({"1", "2", "9", "10", "99", "100"}));
  EXPECT_TRUE(all_follow({"day 11", "day 10", "day 9"}));
  EXPECT_TRUE(all_follow({"2020-9-30 5:00", "2020-9-30 12:00", "2020-10-1 0:00"}));
}

TEST(TimeOrder, ends_where_a_time_comes_twice_or_may_come_again) {
  EXPECT_FALSE(all_follow({"a", "a"}));
  EXPECT_FALSE(all_follow({"1", "2", "1"}));
  EXPECT_FALSE(all_follow({"30.01.2020", "31.01.2020", "01.02.2020"}));
  EXPECT_FALSE(all_follow({"9", "10", "1", "2"})) << "once it does not hold it never does again";
}

TEST(TimeOrder, remembers_the_last_time_alone) {
  TimeOrder order;
  EXPECT_FALSE(order.is_last(""));
  EXPECT_TRUE(order.follows("x"));
  EXPECT_TRUE(order.is_last("x"));
  EXPECT_TRUE(order.follows("y"));
  EXPECT_FALSE(order.is_last("x"));
}

TEST(CompareWithNumbers, finds_the_first_number_that_differs) {
  EXPECT_LT(compare_with_numbers("a2b9", "a10b1"), 0);
  EXPECT_GT(compare_with_numbers("a10b1", "a2b9"), 0);
  EXPECT_LT(compare_with_numbers("12", "123"), 0);
  EXPECT_LT(compare_with_numbers("1-", "1a"), 0);
  EXPECT_LT(compare_with_numbers("a", "a1"), 0);
  EXPECT_LT(compare_with_numbers("-", "1"), 0);
  EXPECT_GT(compare_with_numbers("a", "1"), 0);
  EXPECT_LT(compare_with_numbers("0007", "10"), 0);
  EXPECT_LT(compare_with_numbers("99999999999999999999998", "99999999999999999999999"), 0);
  EXPECT_EQ(compare_with_numbers("same", "same"), 0);
  EXPECT_EQ(compare_with_numbers("01", "1"), 0);
}

TEST(CompareWithNumbers, is_an_order_where_it_is_strict) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const auto text = [&] {
    std::string made;
    for (unsigned n = static_cast<unsigned>(random()) % 6; n > 0; --n)
      made += "0129-a"[random() % 6];
    return made;
  };
  for (int i = 0; i < 200'000; ++i) {
    const std::string a = text();
    const std::string b = text();
    const std::string c = text();
    const int ab = compare_with_numbers(a, b);
    ASSERT_EQ(ab<0, compare_with_numbers(b, a)> 0) << a << ' ' << b;
    if (ab < 0 && compare_with_numbers(b, c) < 0) {
      ASSERT_LT(compare_with_numbers(a, c), 0) << a << ' ' << b << ' ' << c;
    }
  }
}

}  // namespace
}  // namespace thiessen
