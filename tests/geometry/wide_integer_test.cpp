#include "geometry/wide_integer.h"

#include <gtest/gtest.h>
#include <type_traits>

#include <limits>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr std::uint64_t all_ones = ~std::uint64_t{0};

/// 2^exponent at a width.
template <std::size_t Limbs>
WideInteger<Limbs> power_of_two(int exponent) {
  return WideInteger<Limbs>::shifted(1, exponent);
}

TEST(WideInteger, has_the_sign_of_its_value) {
  EXPECT_EQ(WideInteger<4>(0).sign(), 0);
  EXPECT_EQ(WideInteger<4>(7).sign(), 1);
  EXPECT_EQ(WideInteger<4>(-7).sign(), -1);
  EXPECT_EQ(power_of_two<4>(254).sign(), 1);
  EXPECT_EQ((-power_of_two<4>(254)).sign(), -1);
  EXPECT_EQ(WideInteger<1>(-1).sign(), -1);
}

TEST(WideInteger, shifted_digits_land_in_their_limbs) {
  const auto high = WideInteger<3>::shifted(5, 64);
  EXPECT_EQ(high.limb(0), 0u);
  EXPECT_EQ(high.limb(1), 5u);
  EXPECT_EQ(high.limb(2), 0u);
  const auto across = WideInteger<3>::shifted(5, 62);  // 2^64 + 2^62
  EXPECT_EQ(across.limb(0), std::uint64_t{1} << 62);
  EXPECT_EQ(across.limb(1), 1u);
  const auto negative = WideInteger<3>::shifted(-1, 64);
  EXPECT_EQ(negative.limb(0), 0u);
  EXPECT_EQ(negative.limb(1), all_ones);
  EXPECT_EQ(negative.limb(2), all_ones);
}

// What the differences of far points of a fine grid rely on: see whole_vectors.h.
TEST(WideInteger, shifted_digits_that_do_not_fit_leave_what_does) {
  EXPECT_EQ(WideInteger<1>::shifted(3, 63),
            WideInteger<1>(std::numeric_limits<std::int64_t>::min()));
  EXPECT_EQ(WideInteger<1>::shifted(3, 64).sign(), 0);
  EXPECT_EQ(WideInteger<2>::shifted(3, 127).limb(1), std::uint64_t{1} << 63);
  EXPECT_EQ(WideInteger<2>::shifted(3, 128).sign(), 0);
  EXPECT_EQ(WideInteger<2>::shifted(3, 1000).sign(), 0);
  EXPECT_EQ(WideInteger<1>::shifted(3, 63) - WideInteger<1>::shifted(1, 63), WideInteger<1>(0));
  EXPECT_EQ(WideInteger<2>::shifted(5, 126) - WideInteger<2>::shifted(1, 126), WideInteger<2>(0));
}

TEST(WideInteger, carries_and_borrows_through_all_limbs) {
  const auto big = power_of_two<5>(256);
  const auto one_less = big - WideInteger<5>(1);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(one_less.limb(i), all_ones);
  EXPECT_EQ(one_less.limb(4), 0u);
  EXPECT_EQ(one_less + WideInteger<5>(1), big);
  EXPECT_EQ(WideInteger<5>(-1) + WideInteger<5>(1), WideInteger<5>(0));
  EXPECT_EQ(-big + one_less, WideInteger<5>(-1));
}

// (2^64 - 1)^2 = 2^128 - 2^65 + 1, by hand.
TEST(WideInteger, products_have_the_width_of_both_factors) {
  const auto ones = power_of_two<2>(64) - WideInteger<2>(1);
  const auto square = ones * ones;
  EXPECT_EQ(square, power_of_two<4>(128) - power_of_two<4>(65) + WideInteger<4>(1));
  EXPECT_EQ(-ones * ones, -square);
  EXPECT_EQ(ones * -ones, -square);
  EXPECT_EQ(-ones * -ones, square);
  EXPECT_EQ(ones * WideInteger<3>(0), WideInteger<5>(0));
}

TEST(WideInteger, of_the_lowest_value_has_the_right_square) {
  const auto lowest = WideInteger<1>(std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(lowest * lowest, power_of_two<2>(126));
  const auto low = -power_of_two<2>(127);
  EXPECT_EQ(low * low, power_of_two<4>(254));
  EXPECT_EQ(low * WideInteger<1>(-1), power_of_two<3>(127));
}

TEST(WideInteger, products_agree_with_the_processors) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const auto a = static_cast<std::int64_t>(seeded.generator()()) >> seeded.below(64);
    const auto b = static_cast<std::int64_t>(seeded.generator()()) >> seeded.below(64);
    const LongInteger product = LongInteger{a} * b;
    ASSERT_EQ(WideInteger<1>(a) * WideInteger<1>(b), WideInteger<2>::of(product));
    ASSERT_EQ(WideInteger<2>(a) * WideInteger<2>(b), WideInteger<4>::of(product));
    ASSERT_EQ(WideInteger<3>(a) * WideInteger<1>(b), WideInteger<4>::of(product));
  }
}

TEST(WideInteger, products_distribute_over_sums_at_every_width) {
  Seeded seeded;
  const auto random = [&seeded](auto width) {
    WideInteger<width()> sum = 0;
    for (std::size_t i = 0; i < width(); ++i) {
      const auto digits = static_cast<std::int64_t>(seeded.generator()());
      sum = sum + WideInteger<width()>::shifted(digits,
                                                static_cast<int>(seeded.below(64 * width() - 64)));
    }
    return sum;
  };
  for (std::uint64_t round = 0; round < seeded.rounds(2000); ++round) {
    const auto a = random(std::integral_constant<std::size_t, 7>{});
    const auto b = random(std::integral_constant<std::size_t, 7>{});
    const auto c = random(std::integral_constant<std::size_t, 14>{});
    ASSERT_EQ((a + b) * c, a * c + b * c);
    ASSERT_EQ((a - b) * c, a * c - b * c);
    ASSERT_EQ(a * b, b * a);
  }
}

TEST(WideInteger, as_a_double_is_the_nearest_one_the_even_of_two) {
  EXPECT_EQ(WideInteger<3>(0).to_double(), 0);
  EXPECT_EQ(WideInteger<3>(-12).to_double(), -12);
  EXPECT_EQ(power_of_two<3>(190).to_double(-190), 1);
  EXPECT_EQ(WideInteger<3>(3).to_double(-200), 0x3p-200);
  const auto above_one = [](std::int64_t half_ulps) {
    return power_of_two<4>(200) + WideInteger<4>::shifted(half_ulps, 147);
  };
  EXPECT_EQ(above_one(1).to_double(-200), 1);
  EXPECT_EQ(above_one(3).to_double(-200), 0x1.0000000000002p0);
  // Beyond a tie by the last digit of all.
  EXPECT_EQ((above_one(1) + WideInteger<4>(1)).to_double(-200), 0x1.0000000000001p0);
  EXPECT_EQ((above_one(3) - WideInteger<4>(1)).to_double(-200), 0x1.0000000000001p0);
  EXPECT_EQ((-above_one(1) - WideInteger<4>(1)).to_double(-200), -0x1.0000000000001p0);
  EXPECT_EQ(power_of_two<28>(1500).to_double(-1600), 0x1p-100);
}

}  // namespace
}  // namespace thiessen
