#include "gdal/output/isohyet_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace thiessen {
namespace {

// 10 x 10 pixels over (0, 0) to (10, 10), whose value is the x of their centres.
const PixelGrid grid{{0, 10}, 1, 10, 10};

std::vector<float> plane() {
  std::vector<float> values;
  for (int i = 0; i < 100; ++i) values.push_back(static_cast<float>(i % 10) + 0.5F);
  return values;
}

std::vector<MultiPolygon> two_basins() {
  return {{{{{1, 1}, {6, 1}, {6, 4}, {1, 4}}, {}}}, {{{{5, 5}, {9, 5}, {9, 9}, {5, 9}}, {}}}};
}

TEST(IsohyetLines, of_a_plane_are_straight_and_cut_to_the_basins) {
  const auto isohyets = isohyets_of(grid, plane(), std::array{3.25, 5.5, 8.0}, two_basins());
  ASSERT_EQ(isohyets.size(), 4U);
  const std::array<std::pair<std::size_t, double>, 4> wanted{
      {{0, 3.25}, {0, 5.5}, {1, 5.5}, {1, 8}}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(isohyets[i].basin, wanted[i].first);
    EXPECT_EQ(isohyets[i].level, wanted[i].second);
    double length = 0;
    for (const auto& line : isohyets[i].lines) {
      for (std::size_t k = 0; k < line.size(); ++k) {
        EXPECT_NEAR(line[k].x, wanted[i].second, 1e-5);
        if (k > 0) length += std::abs(line[k].y - line[k - 1].y);
      }
    }
    EXPECT_NEAR(length, wanted[i].first == 0 ? 3 : 4, 1e-9);
  }
}

TEST(IsohyetLines, do_not_reach_into_pixels_without_a_value) {
  std::vector<float> values = plane();
  for (std::size_t i = 0; i < 50; ++i) values[i] = std::numeric_limits<float>::quiet_NaN();
  const std::vector<MultiPolygon> all{{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}}}};
  const auto isohyets = isohyets_of(grid, values, std::array{4.0}, all);
  ASSERT_EQ(isohyets.size(), 1U);
  for (const auto& line : isohyets[0].lines) {
    for (const Point p : line) {
      EXPECT_LE(p.y, 5);
      EXPECT_NEAR(p.x, 4, 1e-5);
    }
  }
}

TEST(IsohyetLines, without_levels_are_none) {
  EXPECT_TRUE(isohyets_of(grid, plane(), {}, two_basins()).empty());
  EXPECT_TRUE(isohyets_of(grid, plane(), std::array{50.0}, two_basins()).empty());
}

}  // namespace
}  // namespace thiessen
