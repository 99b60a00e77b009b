#include "geometry/hilbert.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr int side = 64;
constexpr double whole_grid = 65536;

// A coarse cell's number: all points of the cell share the first bits of their distance.
std::uint32_t coarse_distance(int column, int row) {
  const Box box{{0, 0}, {side, side}};
  const double steps = whole_grid / side;
  return hilbert_distance(box, {column + 0.5, row + 0.5}) /
         static_cast<std::uint32_t>(steps * steps);
}

TEST(HilbertDistance, numbers_every_cell_of_a_grid_once) {
  std::vector<int> visits(side * side, 0);
  for (int column = 0; column < side; ++column) {
    for (int row = 0; row < side; ++row) ++visits.at(coarse_distance(column, row));
  }
  EXPECT_EQ(visits, std::vector<int>(side * side, 1));
}

TEST(HilbertDistance, goes_from_each_cell_to_a_neighbour) {
  std::map<std::uint32_t, std::pair<int, int>> cell_at;
  for (int column = 0; column < side; ++column) {
    for (int row = 0; row < side; ++row) cell_at[coarse_distance(column, row)] = {column, row};
  }
  for (std::uint32_t i = 0; i + 1 < side * side; ++i) {
    const auto [column, row] = cell_at.at(i);
    const auto [next_column, next_row] = cell_at.at(i + 1);
    ASSERT_EQ(std::abs(next_column - column) + std::abs(next_row - row), 1) << i;
  }
}

TEST(HilbertDistance, of_a_box_without_width_or_height_stands) {
  EXPECT_EQ(hilbert_distance({{5, 5}, {5, 5}}, {5, 5}), 0u);
  EXPECT_LT(hilbert_distance({{5, 0}, {5, 1}}, {5, 0.2}),
            hilbert_distance({{5, 0}, {5, 1}}, {5, 0.8}));
}

TEST(HilbertDistance, takes_the_box_far_corners) {
  const Box box{{-1, -1}, {1, 1}};
  EXPECT_EQ(hilbert_distance(box, {-1, -1}), 0u);
  EXPECT_EQ(hilbert_distance(box, {1, -1}), 0xFFFFFFFFu);
}

TEST(InsertionOrder, is_a_permutation) {
  Seeded seeded;
  for (const std::size_t count : {0u, 1u, 2u, 63u, 64u, 65u, 128u, 129u, 5000u}) {
    std::vector<Point> points(count);
    for (Point& p : points) p = {std::floor(seeded.uniform(0, 40)), seeded.uniform(0, 1)};
    std::vector<std::uint32_t> order = insertion_order(points);
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(order, all);
  }
}

TEST(InsertionOrder, stays_near_the_point_before) {
  Seeded seeded;
  std::vector<Point> points(100000);
  for (Point& p : points) p = {seeded.uniform(0, 1), seeded.uniform(0, 1)};
  const std::vector<std::uint32_t> order = insertion_order(points);
  double way = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point p = points[order[i - 1]];
    const Point q = points[order[i]];
    way += std::hypot(q.x - p.x, q.y - p.y);
  }
  // Along the curve a step is about n^(-1/2); at random it would be 0.52.
  EXPECT_LT(way / 100000, 0.01);
}

}  // namespace
}  // namespace thiessen
