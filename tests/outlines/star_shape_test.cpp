// What is proven of a ring without GEOS, by rings drawn by hand and by GEOS.
#include "outlines/star_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "geometry/seeded.h"
#include "outlines/polygon_validity.h"

namespace thiessen {
namespace {

TEST(StarShape, has_every_convex_ring) {
  EXPECT_TRUE(is_star_shaped({{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_TRUE(is_star_shaped({{0, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}}));  // with one straight on
  EXPECT_TRUE(is_star_shaped({{1e6, 1e6}, {1e6 + 1e-9, 1e6}, {1e6, 1e6 + 1e-9}}));
}

TEST(StarShape, has_a_ring_that_is_bent_in_a_little) {
  EXPECT_TRUE(is_star_shaped({{0, 0}, {1, 0.1}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(StarShape, no_ring_has_that_folds_turns_twice_or_runs_clockwise) {
  EXPECT_FALSE(is_star_shaped({{0, 0}, {0, 1}, {1, 0}}));
  EXPECT_FALSE(is_star_shaped({{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_FALSE(is_star_shaped({{0, 0}, {2, 0}, {2, 2}, {1, -1}}));                 // crosses itself
  EXPECT_FALSE(is_star_shaped({{0, 0}, {2, 0}, {2, 2}, {3, 3}, {2, 2}, {0, 2}}));  // a spike
  EXPECT_FALSE(is_star_shaped({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  EXPECT_FALSE(is_star_shaped({{0, 1}, {-1, -1}, {1, 0.2}, {-1, 0.2}, {1, -1}}));  // a pentagram
}

TEST(StarShape, no_ring_has_that_is_no_ring) {
  EXPECT_FALSE(is_star_shaped({}));
  EXPECT_FALSE(is_star_shaped({{0, 0}, {1, 0}}));
  EXPECT_FALSE(is_star_shaped({{0, 0}, {1, 0}, {NAN, 1}}));
}

TEST(StarShape, of_random_rings_those_that_have_it_are_valid) {
  Seeded seeded;
  std::uint64_t proven = 0;
  const std::uint64_t rounds = Seeded::rounds(2000);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Ring ring(3 + seeded.below(6));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) /
                           static_cast<double>(ring.size()) * (round % 5 == 0 ? 2 : 1);
      // On a grid, so that corners fall together and edges on each other.
      ring[i] = {std::round(6 * std::cos(angle)) + static_cast<double>(seeded.below(5)),
                 std::round(6 * std::sin(angle)) + static_cast<double>(seeded.below(5))};
    }
    if (!is_star_shaped(ring)) continue;
    ++proven;
    ASSERT_EQ(validity_fault({{ring, {}}}), "");
  }
  EXPECT_GT(proven, rounds / 20);
}

}  // namespace
}  // namespace thiessen
