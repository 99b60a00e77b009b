#include "map/opencv/halo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace thiessen {
namespace {

TEST(Halo, of_a_dot_is_a_disc_about_it) {
  for (const int radius : {1, 2, 3, 5, 9}) {
    Coverage dot(1, 1);
    dot.at(0, 0) = 200;
    const Coverage grown = halo(dot, radius);
    ASSERT_EQ(grown.width, 2 * radius + 1);
    ASSERT_EQ(grown.height, 2 * radius + 1);
    for (int y = -radius; y <= radius; ++y) {
      for (int x = -radius; x <= radius; ++x) {
        const int value = grown.at(x + radius, y + radius);
        const double distance = std::hypot(x, y);
        EXPECT_TRUE(value == 0 || value == 200);
        if (distance <= radius - 0.5 || x == 0 || y == 0) {
          EXPECT_EQ(value, 200) << x << ' ' << y;
        }
        if (distance > radius + 1) {
          EXPECT_EQ(value, 0) << x << ' ' << y;
        }
      }
    }
  }
}

TEST(Halo, of_no_radius_is_the_coverage_itself_and_of_nothing_is_empty) {
  Coverage ink(3, 2);
  ink.at(2, 1) = 7;
  EXPECT_EQ(halo(ink, 0).values, ink.values);
  EXPECT_EQ(halo(Coverage(), 2).values, std::vector<std::uint8_t>(16, 0));
}

// A halo is the union of discs: each pixel is the largest of what the dots alone would give it.
TEST(Halo, law_1_of_many_dots_is_the_largest_of_their_halos) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  constexpr int radius = 3;
  Coverage ink(20, 15);
  Coverage expected(20 + 2 * radius, 15 + 2 * radius);
  for (int n = 0; n < 12; ++n) {
    const int x = static_cast<int>(random() % 20);
    const int y = static_cast<int>(random() % 15);
    Coverage dot(20, 15);
    ink.at(x, y) = dot.at(x, y) = static_cast<std::uint8_t>(random() % 255 + 1);
  }
  for (int y = 0; y < 15; ++y) {
    for (int x = 0; x < 20; ++x) {
      Coverage dot(20, 15);
      dot.at(x, y) = ink.at(x, y);
      const Coverage alone = halo(dot, radius);
      for (std::size_t i = 0; i < expected.values.size(); ++i)
        expected.values[i] = std::max(expected.values[i], alone.values[i]);
    }
  }
  EXPECT_EQ(halo(ink, radius).values, expected.values);
}

}  // namespace
}  // namespace thiessen
