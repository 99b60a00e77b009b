#include "map/sheet/map_grid.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

constexpr GridGaps no_gaps;

// Twelve squares in 400 x 300 pixels are largest as 4 x 3, at 100 pixels a side.
TEST(MapGrid, makes_maps_as_large_as_the_room_has_it) {
  const MapGrid twelve = best_grid(12, 1, {400, 300}, no_gaps);
  EXPECT_EQ(twelve.columns, 4);
  EXPECT_EQ(twelve.rows, 3);
  EXPECT_EQ(twelve.width, 100);
  EXPECT_EQ(twelve.height, 100);
  EXPECT_EQ(best_grid(12, 1, {300, 400}, no_gaps).columns, 3);
  EXPECT_EQ(best_grid(3, 3, {400, 400}, no_gaps).rows, 3) << "wide maps stand one below the other";
  EXPECT_EQ(best_grid(3, 0.5, {400, 400}, no_gaps).rows, 1);
}

// Of two maps twice as wide as high one above the other makes a page of 400 x 400, and side by
// side one of 400 x 100; the former is nearer to 1.41.
TEST(MapGrid, of_an_open_height_gives_the_page_the_proportions_of_paper) {
  EXPECT_EQ(best_grid(2, 2, {400, 0}, no_gaps).rows, 2);
  EXPECT_EQ(best_grid(2, 2, {400, 0}, no_gaps).height, 200);
  EXPECT_EQ(best_grid(2, 1, {400, 0}, no_gaps).columns, 2) << "400 x 200, and not 400 x 800";
  EXPECT_EQ(best_grid(2, 1, {400, 0}, no_gaps).height, 200);
}

TEST(MapGrid, law_1_every_map_has_a_place_of_its_own_in_the_room) {
  const GridGaps gaps{7, 20};
  for (std::size_t maps = 1; maps <= 40; ++maps) {
    const MapGrid grid = best_grid(maps, 1.3, {1000, 800}, gaps);
    const auto places = places_in(grid, maps, 50, 60, gaps);
    ASSERT_EQ(places.size(), maps);
    EXPECT_GT(static_cast<int>(maps), (grid.rows - 1) * grid.columns) << "no row is empty";
    for (std::size_t i = 0; i < maps; ++i) {
      EXPECT_GE(places[i].x, 50);
      EXPECT_GE(places[i].y, 60 + gaps.above);
      EXPECT_LE(places[i].right(), 1050);
      EXPECT_LE(places[i].bottom(), 860);
      if (i > 0 && places[i].y == places[i - 1].y) {
        EXPECT_EQ(places[i].x, places[i - 1].right() + gaps.across);
      } else if (i > 0) {
        EXPECT_EQ(places[i].y, places[i - 1].bottom() + gaps.above);
      }
    }
  }
}

TEST(MapGrid, knows_below_which_maps_nothing_stands) {
  const MapGrid grid{3, 2, 10, 10};
  EXPECT_FALSE(is_lowest(grid, 5, 1));
  EXPECT_TRUE(is_lowest(grid, 5, 2)) << "the last row has two";
  EXPECT_TRUE(is_lowest(grid, 5, 3));
}

TEST(MapGrid, without_room_has_no_width) {
  EXPECT_EQ(best_grid(100, 1, {20, 20}, {5, 30}).width, 0);
}

}  // namespace
}  // namespace thiessen
