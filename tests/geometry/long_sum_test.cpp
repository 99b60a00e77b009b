#include "geometry/long_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/seeded.h"
#include "geometry/wide_integer.h"

namespace thiessen {
namespace {

double sum_of(const std::vector<double>& terms) {
  LongSum sum;
  for (const double term : terms) sum.add(term);
  return sum.value();
}

// Whole numbers over 2^52, whose sums fit in 128 bits: they are exact there.
TEST(LongSum, law_1_is_the_exact_sum_rounded_once) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(2000); ++round) {
    LongInteger exact = 0;
    LongSum sum;
    for (int i = 0; i < 100; ++i) {
      const auto term = seeded.whole(-(std::int64_t{1} << 52), std::int64_t{1} << 52);
      const int shift = static_cast<int>(seeded.below(40));
      exact += static_cast<LongInteger>(term) << shift;
      sum.add(std::ldexp(static_cast<double>(term), shift));
    }
    ASSERT_EQ(sum.value(), static_cast<double>(exact));
  }
}

TEST(LongSum, law_2_the_order_of_the_terms_does_not_matter) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(200); ++round) {
    std::vector<double> terms;
    for (int i = 0; i < 50; ++i)
      terms.push_back(std::ldexp(seeded.uniform(-1, 1), static_cast<int>(seeded.below(20))));
    const double first = sum_of(terms);
    for (int i = 0; i < 5; ++i) {
      std::shuffle(terms.begin(), terms.end(), seeded.generator());
      ASSERT_EQ(sum_of(terms), first);
    }
    std::sort(terms.begin(), terms.end());
    ASSERT_EQ(sum_of(terms), first);
  }
}

TEST(LongSum, of_what_cancels_is_what_is_left) {
  EXPECT_EQ(sum_of({}), 0);
  EXPECT_EQ(sum_of({1e16, 1, -1e16}), 1);
  EXPECT_EQ(sum_of({1, 0x1p-60, -1}), 0x1p-60);
  EXPECT_EQ(sum_of({0.1, 0.2, -0.3}), 0x1p-55);  // of the three doubles
  EXPECT_TRUE(std::isnan(sum_of({1, std::nan(""), 1})));
}

}  // namespace
}  // namespace thiessen
