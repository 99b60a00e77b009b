#include "map/raster/block_owners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace thiessen {
namespace {

/// What no pixel that was settled holds.
constexpr std::int32_t untouched = -1;

// Pixels 1 wide, their centres at halves, from 0 to 200 eastward and southward.
const PixelGrid grid{{0, 0}, 1, 200, 200};

TEST(BlockOwners, give_all_pixels_of_a_block_and_no_others) {
  const auto places = nearest_places(std::vector<Point>{{50, -100}, {150, -100}}, Metric::planar);
  const std::vector<std::int32_t> numbers{4, 9};
  std::vector<std::int32_t> owners(40000, untouched);
  BlockOwners settling(grid, *places, numbers, [](std::vector<Point>&) {});
  settling.settle({10, 20, 150, 130}, {0, owners});
  for (std::size_t i = 0; i < 40000; ++i) {
    const std::size_t column = i % 200;
    const std::size_t row = i / 200;
    const bool within = column >= 10 && column < 160 && row >= 20 && row < 150;
    ASSERT_EQ(owners[i], within ? (column < 100 ? 4 : 9) : untouched) << column << " " << row;
  }
}

TEST(BlockOwners, ask_for_the_positions_of_few_pixels) {
  const auto places = nearest_places(std::vector<Point>{{50, -100}, {150, -90}}, Metric::planar);
  const std::vector<std::int32_t> numbers{1, 2};
  std::vector<std::int32_t> owners(40000, untouched);
  std::size_t asked = 0;
  const auto count = [&](std::vector<Point>& points) { asked += points.size(); };
  BlockOwners settling(grid, *places, numbers, count);
  settling.settle({0, 0, 200, 200}, {0, owners});
  EXPECT_EQ(std::count(owners.begin(), owners.end(), untouched), 0);
  EXPECT_LT(asked, 60U);
}

TEST(BlockOwners, go_to_every_pixel_where_positions_are_not_even) {
  const auto places = nearest_places(std::vector<Point>{{50, -100}, {150, -100}}, Metric::planar);
  const std::vector<std::int32_t> numbers{1, 2};
  std::vector<std::int32_t> owners(40000, untouched);
  // Every third column is nowhere.
  const auto striped = [](std::vector<Point>& points) {
    for (Point& p : points) {
      if (static_cast<int>(p.x) % 3 == 0) p.y = std::numeric_limits<double>::quiet_NaN();
    }
  };
  BlockOwners settling(grid, *places, numbers, striped);
  settling.settle({0, 0, 200, 200}, {0, owners});
  for (std::size_t i = 0; i < 40000; ++i) {
    const std::size_t column = i % 200;
    ASSERT_EQ(owners[i], column % 3 == 0 ? 0 : (column < 100 ? 1 : 2)) << column;
  }
}

}  // namespace
}  // namespace thiessen
