#include "earth/nearest/near_places.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace thiessen {
namespace {

constexpr double anywhere = std::numeric_limits<double>::infinity();

// Four places on a line, at 0, 1, 2 and 3; two of them stand equally far from 1.
const PlaceTree& four_in_a_row() {
  static const PlaceTree tree({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  return tree;
}

std::vector<PlaceIndex> found(std::size_t count, double farthest, PlaceIndex passed_over,
                              bool lesser_first) {
  std::vector<NearPlace> near{{PlaceIndex{3}, 0}};
  find_near_places(
      four_in_a_row(), {1, 0, 0}, count, farthest, [&](PlaceIndex p) { return p != passed_over; },
      [&](PlaceIndex a, PlaceIndex b) { return lesser_first ? a < b : b < a; }, near);
  std::vector<PlaceIndex> places;
  for (const NearPlace& n : near) places.push_back(n.place);
  return places;
}

TEST(NearPlaces, come_in_the_order_of_their_distances_and_ties_as_they_are_wanted) {
  EXPECT_EQ(found(4, anywhere, PlaceIndex{1}, true),
            (std::vector{PlaceIndex{0}, PlaceIndex{2}, PlaceIndex{3}}));
  EXPECT_EQ(found(2, anywhere, PlaceIndex{1}, false), (std::vector{PlaceIndex{2}, PlaceIndex{0}}));
  EXPECT_EQ(found(1, anywhere, PlaceIndex{1}, false), std::vector{PlaceIndex{2}});
  EXPECT_TRUE(found(0, anywhere, PlaceIndex{1}, true).empty());
}

TEST(NearPlaces, at_the_bound_itself_are_found) {
  EXPECT_EQ(found(2, 1.0, PlaceIndex{1}, true), (std::vector{PlaceIndex{0}, PlaceIndex{2}}));
}

}  // namespace
}  // namespace thiessen
