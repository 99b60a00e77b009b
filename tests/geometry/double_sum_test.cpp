#include "geometry/double_sum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/seeded.h"
#include "geometry/wide_integer.h"

namespace thiessen {
namespace {

constexpr std::int64_t largest = (std::int64_t{1} << 53) - 1;

LongInteger whole(const DoubleSum& sum) {
  return static_cast<LongInteger>(sum.high) + static_cast<LongInteger>(sum.low);
}

TEST(DoubleSum, of_two_whole_numbers_is_exact) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2000); ++round) {
    const std::int64_t a = seeded.whole(-largest, largest);
    const std::int64_t b = seeded.whole(-largest, largest) >> seeded.below(53);
    const auto x = static_cast<double>(a), y = static_cast<double>(b);
    ASSERT_EQ(whole(DoubleSum::of_sum(x, y)), LongInteger{a} + b);
    ASSERT_EQ(whole(DoubleSum::of_difference(x, y)), LongInteger{a} - b);
    ASSERT_EQ(whole(HalvedDouble(x) * HalvedDouble(y)), LongInteger{a} * b);
  }
}

// A third factor of 20 digits leaves 126 of them.
TEST(DoubleSum, products_and_their_sums_are_right_to_2_to_the_minus_102) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2000); ++round) {
    const auto product = [&](LongInteger& exact, double& magnitude) {
      const std::int64_t a = seeded.whole(-largest, largest), b = seeded.whole(-largest, largest);
      const std::int64_t c = seeded.whole(-(1 << 20), 1 << 20);
      exact = LongInteger{a} * b * c;
      const DoubleSum result =
          product_of(HalvedDouble(static_cast<double>(a)) * HalvedDouble(static_cast<double>(b)),
                     HalvedDouble(static_cast<double>(c)));
      magnitude = std::abs(result.high);
      EXPECT_LE(std::abs(static_cast<double>(whole(result) - exact)), 0x1p-102 * magnitude);
      return result;
    };
    LongInteger first = 0, second = 0;
    double first_size = 0, second_size = 0;
    const DoubleSum a = product(first, first_size);
    const DoubleSum b = product(second, second_size);
    const DoubleSum difference = sum_of(a, -1, b);
    const double error = static_cast<double>(whole(difference) - (first - second));
    ASSERT_LE(std::abs(error), 0x1p-101 * (first_size + second_size));
  }
}

TEST(DoubleSum, rounds_for_certain_unless_half_a_digit_is_near) {
  EXPECT_TRUE(rounds_for_certain({1, 0}, 0x1p-60));
  EXPECT_TRUE(rounds_for_certain({1, 0x1p-54}, 0x1p-60));
  EXPECT_FALSE(rounds_for_certain({1, 0x1p-53}, 0x1p-60));
  EXPECT_FALSE(rounds_for_certain({1 + 0x1p-52, -0x1p-53}, 0x1p-60));
  EXPECT_TRUE(rounds_for_certain({0, 0}, 0));
  EXPECT_FALSE(rounds_for_certain({0, 0}, 0x1p-60));
}

}  // namespace
}  // namespace thiessen
