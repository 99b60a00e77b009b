#include "earth/nearest/place_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

double square_between(Direction a, Direction b) {
  return dot(a - b, a - b);
}

/// In space, in a plane, on a line, or all at one of a few points.
std::vector<Direction> places_of(Seeded& seeded, std::uint64_t kind) {
  std::vector<Direction> places;
  for (std::uint64_t i = 1 + seeded.below(200); i-- > 0;) {
    Direction p{seeded.uniform(-1, 1), seeded.uniform(-1, 1), seeded.uniform(-1, 1)};
    if (kind > 0) p.z = 0;
    if (kind > 1) p.y = p.x;
    if (kind > 2) p.x = p.y = std::round(p.x);
    places.push_back(p);
  }
  return places;
}

TEST(PlaceTree, finds_the_nearest) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(200); ++round) {
    const std::vector<Direction> places = places_of(seeded, round % 4);
    const PlaceTree tree(places);
    for (int i = 0; i < 20; ++i) {
      const Direction p{seeded.uniform(-2, 2), seeded.uniform(-2, 2), seeded.uniform(-2, 2)};
      double least = HUGE_VAL;
      for (const Direction q : places) least = std::min(least, square_between(p, q));
      ASSERT_EQ(square_between(p, tree[tree.nearest(p)]), least);
      const PlaceIndex guess{static_cast<std::uint32_t>(seeded.below(places.size()))};
      ASSERT_EQ(tree.nearest(p, guess), tree.nearest(p));
    }
  }
}

TEST(PlaceTree, searches_all_but_what_is_excluded) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(200); ++round) {
    const std::vector<Direction> places = places_of(seeded, round % 4);
    const PlaceTree tree(places);
    const Ball wanted{places.front(), seeded.uniform(0, 1)};
    std::vector<int> found(places.size(), 0);
    tree.search(
        [&](const Ball& part) {
          return length(part.centre - wanted.centre) > wanted.radius + part.radius + 1e-12;
        },
        [&](PlaceIndex p) { ++found[index(p)]; });
    for (std::size_t i = 0; i < places.size(); ++i) {
      ASSERT_LE(found[i], 1);
      const bool is_wanted = length(places[i] - wanted.centre) <= wanted.radius;
      ASSERT_TRUE(!is_wanted || found[i] == 1);
    }
  }
}

TEST(PlaceTree, looks_at_few_of_many) {
  Seeded seeded;
  std::vector<Direction> places;
  for (int i = 0; i < 10000; ++i) places.push_back({seeded.uniform(0, 1), seeded.uniform(0, 1), 0});
  const PlaceTree tree(places);
  int parts = 0;
  int found = 0;
  tree.search(
      [&](const Ball& part) {
        ++parts;
        return length(part.centre - Direction{0.5, 0.5, 0}) > 0.01 + part.radius;
      },
      [&](PlaceIndex) { ++found; });
  EXPECT_LT(parts, 200);
  EXPECT_LT(found, 200);
}

}  // namespace
}  // namespace thiessen
