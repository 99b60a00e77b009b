#include "map/sheet/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace thiessen {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Relative luminance would do as well: any measure that grows with lightness.
double lightness(Colour c) {
  return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue;
}

TEST(Palette, lightness_always_goes_one_way) {
  for (const Palette palette :
       {Palette::viridis, Palette::blues, Palette::browns, Palette::greys}) {
    const double sign = palette == Palette::viridis ? -1 : 1;
    for (std::size_t count = 2; count <= 9; ++count) {
      for (std::size_t i = 1; i < count; ++i) {
        const double before = lightness(sequential_colour(palette, i - 1, count));
        EXPECT_GT(sign * (before - lightness(sequential_colour(palette, i, count))), 8)
            << count << ' ' << i;
      }
    }
  }
}

/// The triangles of a lattice with a diagonal in each field, at random one way or the other.
Pairs planar_pairs(std::mt19937& random, std::uint32_t side) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const std::uint32_t here = i * side + j;
      if (j + 1 < side) pairs.push_back({here, here + 1});
      if (i + 1 < side) pairs.push_back({here + side, here});
      if (i + 1 == side || j + 1 == side) continue;
      pairs.push_back(random() % 2 == 0 ? Pairs::value_type{here, here + side + 1}
                                        : Pairs::value_type{here + 1, here + side});
    }
  }
  return pairs;
}

TEST(Palette, neighbours_on_a_map_differ_with_six_colours) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    const std::uint32_t side = 5 + seed;
    const Pairs pairs = planar_pairs(random, side);
    const auto colours = colour_neighbours(side * side, pairs, 6);
    for (const auto& [a, b] : pairs) ASSERT_NE(colours[a], colours[b]) << "seed " << seed;
  }
}

TEST(Palette, the_order_of_pairs_does_not_matter) {
  std::mt19937 random(3);
  Pairs pairs = planar_pairs(random, 12);
  const auto first = colour_neighbours(144, pairs, 8);
  std::shuffle(pairs.begin(), pairs.end(), random);
  for (auto& pair : pairs) std::swap(pair.first, pair.second);
  pairs.insert(pairs.end(), pairs.begin(), pairs.begin() + 20);
  EXPECT_EQ(colour_neighbours(144, pairs, 8), first);
}

TEST(Palette, colours_are_used_evenly_and_a_clique_too_large_still_gets_colours) {
  const auto alone = colour_neighbours(80, {}, 8);
  for (std::uint8_t c = 0; c < 8; ++c) EXPECT_EQ(std::count(alone.begin(), alone.end(), c), 10);
  Pairs clique;
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (std::uint32_t j = 0; j < i; ++j) clique.push_back({i, j});
  }
  const auto colours = colour_neighbours(12, clique, 8);
  for (const std::uint8_t c : colours) EXPECT_LT(c, 8);
}

}  // namespace
}  // namespace thiessen
