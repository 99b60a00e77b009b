#include "map/raster/area_rows.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace thiessen {
namespace {

using Pixels = std::vector<std::int32_t>;

// Columns 0 to 5 from 100 on, rows 0 to 4 from 50 down, 10 wide.
const PixelGrid grid{{100, 50}, 10, 5, 5};

Ring rectangle(double west, double south, double east, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

/// The pixels as numbers, row by row: `inside` in an area, else 0.
Pixels pixels(const AreaRows& areas, int row, int count, std::int32_t inside) {
  const AreaSpans spans = areas.rows(row, count);
  Pixels all;
  for (int r = 0; r < count; ++r) {
    const std::size_t first = all.size();
    all.resize(first + 5, 0);
    int before = -1;
    for (const PixelSpan span : spans.row(r)) {
      EXPECT_LT(before, span.first) << "spans touch";
      EXPECT_LT(span.first, span.end);
      before = span.end;
      for (int column = span.first; column < span.end; ++column)
        all[first + static_cast<std::size_t>(column)] = inside;
    }
  }
  return all;
}

TEST(AreaRows, hold_centres_inside_and_not_in_holes) {
  const AreaRows areas(grid, {{{rectangle(104, 0, 146, 36), {rectangle(110, 10, 120, 20)}}}});
  EXPECT_EQ(pixels(areas, 0, 5, 7), (Pixels{0, 0, 0, 0, 0,  //
                                            7, 7, 7, 7, 7,  //
                                            7, 7, 7, 7, 7,  //
                                            7, 0, 7, 7, 7,  //
                                            7, 7, 7, 7, 7}));
}

TEST(AreaRows, are_the_same_in_any_band) {
  const AreaRows areas(grid,
                       {{{rectangle(100, 11, 131, 36), {}}}, {{rectangle(120, 0, 150, 20), {}}}});
  const Pixels whole = pixels(areas, 0, 5, -1);
  EXPECT_EQ(whole, (Pixels{0,  0,  0,  0,  0,   //
                           -1, -1, -1, 0,  0,   //
                           -1, -1, -1, 0,  0,   //
                           -1, -1, -1, -1, -1,  //
                           0,  0,  -1, -1, -1}));
  for (int row = 0; row < 5; ++row) {
    for (int count = 1; row + count <= 5; ++count) {
      EXPECT_EQ(pixels(areas, row, count, -1),
                Pixels(whole.begin() + 5 * row, whole.begin() + 5 * (row + count)));
    }
  }
}

TEST(AreaRows, overlapping_areas_are_inside_once_and_areas_outside_not_at_all) {
  const AreaRows areas(grid, {{{rectangle(100, 0, 150, 50), {}}},
                              {{rectangle(100, 0, 150, 50), {}}},
                              {{rectangle(-100, -100, 0, 0), {}}}});
  EXPECT_EQ(pixels(areas, 1, 2, 1), Pixels(10, 1));
  EXPECT_EQ(pixels(AreaRows(grid, {}), 0, 5, 1), Pixels(25, 0));
}

}  // namespace
}  // namespace thiessen
