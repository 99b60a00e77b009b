// WideInteger against GMP's whole numbers.
#include "geometry/wide_integer.h"

#include <gtest/gtest.h>

#include <bit>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

using Integer = boost::multiprecision::mpz_int;
using Rational = boost::multiprecision::mpq_rational;

template <std::size_t Limbs>
Integer value_of(const WideInteger<Limbs>& wide) {
  Integer value = 0;
  for (std::size_t i = Limbs; i-- > 0;) value = (value << 64) + wide.limb(i);
  if (wide.is_negative()) value -= Integer(1) << (64 * Limbs);
  return value;
}

/// Anything the width holds, often with long runs of zeros and ones.
template <std::size_t Limbs>
WideInteger<Limbs> random_integer(Seeded& seeded) {
  WideInteger<Limbs> sum = 0;
  for (auto terms = seeded.below(2 * Limbs); terms-- > 0;) {
    const auto digits = seeded.below(2) == 0 ? seeded.whole(-2, 2)
                                             : static_cast<std::int64_t>(seeded.generator()()) >> 4;
    sum = sum + WideInteger<Limbs>::shifted(digits, static_cast<int>(seeded.below(64 * Limbs)));
  }
  return sum;
}

template <std::size_t N, std::size_t M>
void expect_arithmetic_of_gmp(Seeded& seeded) {
  const auto a = random_integer<N>(seeded), b = random_integer<N>(seeded);
  const auto c = random_integer<M>(seeded);
  ASSERT_EQ(value_of(a * c), value_of(a) * value_of(c));
  ASSERT_EQ(value_of(c * a), value_of(a) * value_of(c));
  ASSERT_EQ(value_of(a).sign(), a.sign());
  const auto wide_a = a * WideInteger<1>(1), wide_b = b * WideInteger<1>(1);
  ASSERT_EQ(value_of(wide_a + wide_b), value_of(a) + value_of(b));
  ASSERT_EQ(value_of(wide_a - wide_b), value_of(a) - value_of(b));
  ASSERT_EQ(value_of(-wide_a), -value_of(a));
}

TEST(WideIntegerAgainstGmp, sums_differences_products_and_signs) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5000); ++round) {
    expect_arithmetic_of_gmp<1, 1>(seeded);
    expect_arithmetic_of_gmp<1, 2>(seeded);
    expect_arithmetic_of_gmp<2, 2>(seeded);
    expect_arithmetic_of_gmp<3, 2>(seeded);
    expect_arithmetic_of_gmp<6, 4>(seeded);
    expect_arithmetic_of_gmp<7, 7>(seeded);
    expect_arithmetic_of_gmp<21, 14>(seeded);
    if (HasFatalFailure()) return;
  }
}

// No double is nearer, and of two as near the one with an even last digit is taken.
TEST(WideIntegerAgainstGmp, as_a_double_is_the_nearest) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const auto a = random_integer<7>(seeded);
    const double nearest = a.to_double();
    const auto error_of = [&](double value) {
      return Rational(abs(Rational(value) - Rational(value_of(a))));
    };
    const Rational error = error_of(nearest);
    for (const double neighbour :
         {std::nextafter(nearest, HUGE_VAL), std::nextafter(nearest, -HUGE_VAL)}) {
      const Rational other = error_of(neighbour);
      ASSERT_LE(error, other);
      const bool is_even = (std::bit_cast<std::uint64_t>(nearest) & 1) == 0;
      ASSERT_TRUE(error < other || is_even);
    }
  }
}

}  // namespace
}  // namespace thiessen
