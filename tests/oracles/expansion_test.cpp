#include "geometry/expansion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/seeded.h"
#include "oracles/exact.h"

namespace thiessen {
namespace {

using exactly::Rational;

template <std::size_t N>
Rational value_of(const Expansion<N>& e) {
  Rational sum = 0;
  for (std::size_t i = 0; i < e.size(); ++i) sum += Rational(e[i]);
  return sum;
}

// What an expansion promises: no zeros, growing, and no two terms that overlap.
template <std::size_t N>
void expect_sound(const Expansion<N>& e) {
  for (std::size_t i = 0; i < e.size(); ++i) ASSERT_NE(e[i], 0);
  for (std::size_t i = 0; i + 1 < e.size(); ++i) {
    int exponent = 0;
    std::frexp(e[i], &exponent);  // |e[i]| < 2^exponent
    ASSERT_EQ(std::fmod(e[i + 1], std::ldexp(1, exponent)), 0) << e[i] << " " << e[i + 1];
  }
}

double random_term(Seeded& seeded) {
  switch (seeded.below(4)) {
    case 0:
      return static_cast<double>(seeded.whole(-4, 4));
    case 1:
      return seeded.near(1, 3);
    case 2:
      return std::ldexp(1, static_cast<int>(seeded.whole(-120, 120)));
    default:
      return std::ldexp(seeded.uniform(-1, 1), static_cast<int>(seeded.whole(-120, 120)));
  }
}

TEST(Expansion, of_a_difference_is_exact) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const double a = random_term(seeded);
    const double b = random_term(seeded);
    const auto e = exact::difference(a, b);
    expect_sound(e);
    ASSERT_EQ(value_of(e), Rational(a) - Rational(b));
  }
}

TEST(Expansion, sums_differences_and_products_are_exact) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5000); ++round) {
    const auto u = exact::difference(random_term(seeded), random_term(seeded));
    const auto v = exact::difference(random_term(seeded), random_term(seeded));
    const auto product = u * v;
    const auto sum = product + u;
    const auto long_product = sum * product;
    const auto rest = long_product - product * sum;
    ASSERT_EQ(value_of(product), value_of(u) * value_of(v));
    ASSERT_EQ(value_of(sum), value_of(product) + value_of(u));
    ASSERT_EQ(value_of(long_product), value_of(sum) * value_of(product));
    ASSERT_EQ(rest.sign(), 0);
    ASSERT_EQ(value_of(-sum), -value_of(sum));
    expect_sound(product);
    expect_sound(sum);
    expect_sound(long_product);
  }
}

TEST(Expansion, has_the_sign_of_its_value_and_an_estimate_within_2_to_the_minus_52) {
  Seeded seeded;
  const Rational allowed(0x1p-52);
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const auto e = exact::difference(random_term(seeded), random_term(seeded)) *
                       exact::difference(random_term(seeded), random_term(seeded)) -
                   exact::difference(random_term(seeded), random_term(seeded)) *
                       exact::difference(random_term(seeded), random_term(seeded));
    const Rational value = value_of(e);
    ASSERT_EQ(e.sign(), value.sign());
    ASSERT_LE(abs(Rational(e.estimate()) - value), allowed * abs(value));
  }
}

}  // namespace
}  // namespace thiessen
