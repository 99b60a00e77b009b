#include "map/raster/area_rows.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

using Pixels = std::vector<std::int32_t>;

// Columns 0 to 5 from 100 on, rows 0 to 4 from 50 down, 10 wide.
const PixelGrid grid{{100, 50}, 10, 5, 5};

Ring rectangle(double west, double south, double east, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

TEST(AreaRows, hold_centres_inside_and_not_in_holes) {
  const AreaRows areas(grid, {{{rectangle(104, 0, 146, 36), {rectangle(110, 10, 120, 20)}}}});
  EXPECT_EQ(areas.rows(0, 5, 7), (Pixels{0, 0, 0, 0, 0,  //
                                         7, 7, 7, 7, 7,  //
                                         7, 7, 7, 7, 7,  //
                                         7, 0, 7, 7, 7,  //
                                         7, 7, 7, 7, 7}));
}

TEST(AreaRows, are_the_same_in_any_band) {
  const AreaRows areas(grid,
                       {{{rectangle(100, 11, 131, 36), {}}}, {{rectangle(120, 0, 150, 20), {}}}});
  const Pixels whole = areas.rows(0, 5, -1);
  EXPECT_EQ(whole, (Pixels{0,  0,  0,  0,  0,   //
                           -1, -1, -1, 0,  0,   //
                           -1, -1, -1, 0,  0,   //
                           -1, -1, -1, -1, -1,  //
                           0,  0,  -1, -1, -1}));
  for (int row = 0; row < 5; ++row) {
    for (int count = 1; row + count <= 5; ++count) {
      EXPECT_EQ(areas.rows(row, count, -1),
                Pixels(whole.begin() + 5 * row, whole.begin() + 5 * (row + count)));
    }
  }
}

TEST(AreaRows, overlapping_areas_are_inside_once_and_areas_outside_not_at_all) {
  const AreaRows areas(grid, {{{rectangle(100, 0, 150, 50), {}}},
                              {{rectangle(100, 0, 150, 50), {}}},
                              {{rectangle(-100, -100, 0, 0), {}}}});
  EXPECT_EQ(areas.rows(1, 2, 1), Pixels(10, 1));
  EXPECT_EQ(AreaRows(grid, {}).rows(0, 5, 1), Pixels(25, 0));
}

}  // namespace
}  // namespace thiessen
