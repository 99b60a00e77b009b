#include "geometry/segment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

TEST(Between, is_at_its_share_of_the_way_and_exactly_at_the_beginning) {
  EXPECT_EQ(between({1, 2}, {5, -6}, 0.25), (Point{2, 0}));
  EXPECT_EQ(between({1, 2}, {5, -6}, 1), (Point{5, -6}));
  Seeded seeded;
  for (int i = 0; i < 100; ++i) {
    const Point from{seeded.uniform(-1, 1), seeded.uniform(-1, 1)};
    EXPECT_EQ(between(from, {seeded.uniform(-1, 1), 7}, 0), from);
  }
}

// Boole's rule is exact for polynomials of the fifth degree: those that are 0 at both ends are x (1
// - x) times one of the third, and the mean of x^n (1 - x) is 1 / ((n + 1) (n + 2)).
TEST(BooleSamples, give_the_mean_of_a_curve_of_the_fifth_degree_that_meets_both_ends) {
  for (int n = 1; n <= 4; ++n) {
    double mean = 0;
    for (const BooleSample& sample : boole_samples)
      mean += sample.weight * std::pow(sample.along, n) * (1 - sample.along);
    EXPECT_NEAR(mean, 1.0 / ((n + 1) * (n + 2)), 1e-15) << n;
  }
}

}  // namespace
}  // namespace thiessen
