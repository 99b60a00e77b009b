#include "geometry/hilbert.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <vector>

namespace thiessen {
namespace {

template <int Dimension>
using Cell = CoordinatesIn<Dimension, int>;

Point centre_of(const Cell<2>& cell) {
  return {cell[0] + 0.5, cell[1] + 0.5};
}
SpacePoint centre_of(const Cell<3>& cell) {
  return {cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5};
}

// All cells of a grid of `side` cells a side.
template <int Dimension>
std::vector<Cell<Dimension>> cells_of(int side) {
  std::vector<Cell<Dimension>> cells{{}};
  for (std::size_t axis = 0; axis < std::size_t{Dimension}; ++axis) {
    std::vector<Cell<Dimension>> longer;
    for (Cell<Dimension> cell : cells) {
      for (int i = 0; i < side; ++i) {
        cell[axis] = i;
        longer.push_back(cell);
      }
    }
    cells = longer;
  }
  return cells;
}

template <int Dimension>
HilbertGrid<Dimension> grid_of_side(double side) {
  CoordinatesIn<Dimension> high;
  high.fill(side);
  return {{}, high};
}

// The cells of a grid of 2^levels a side, by what the first bits of the distance say.
template <int Dimension>
std::map<std::uint32_t, Cell<Dimension>> cells_by_distance(int levels) {
  const HilbertGrid<Dimension> grid = grid_of_side<Dimension>(1 << levels);
  const int finer = Dimension * (HilbertGrid<Dimension>::levels - levels);
  std::map<std::uint32_t, Cell<Dimension>> at;
  for (const Cell<Dimension>& cell : cells_of<Dimension>(1 << levels)) {
    at[grid.distance(centre_of(cell)) >> finer] = cell;
  }
  return at;
}

template <int Dimension>
int steps_between(const Cell<Dimension>& a, const Cell<Dimension>& b) {
  int steps = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) steps += std::abs(a[axis] - b[axis]);
  return steps;
}

// The curve comes to each cell once, and goes on to a neighbour.
template <int Dimension>
void expect_a_walk_through_every_cell(int levels) {
  const auto at = cells_by_distance<Dimension>(levels);
  const std::uint32_t count = 1u << (Dimension * levels);
  ASSERT_EQ(at.size(), count);
  ASSERT_EQ(at.rbegin()->first, count - 1);
  for (std::uint32_t i = 0; i + 1 < count; ++i) {
    ASSERT_EQ(steps_between<Dimension>(at.at(i), at.at(i + 1)), 1)
        << "levels " << levels << ' ' << i;
  }
}

TEST(HilbertGrid, in_the_plane_walks_through_every_cell) {
  for (int levels = 1; levels <= 9; ++levels) expect_a_walk_through_every_cell<2>(levels);
}

TEST(HilbertGrid, in_space_walks_through_every_cell) {
  for (int levels = 1; levels <= 6; ++levels) expect_a_walk_through_every_cell<3>(levels);
}

TEST(HilbertGrid, walks_through_the_finest_cells) {
  const HilbertGrid<2> grid = grid_of_side<2>(65536);
  std::map<std::uint32_t, Cell<2>> at;
  for (Cell<2> cell : cells_of<2>(64)) {
    cell = {cell[0] + 64 * 711, cell[1] + 64 * 45};
    at[grid.distance(centre_of(cell))] = cell;
  }
  ASSERT_EQ(at.size(), 4096u);
  const std::uint32_t first = at.begin()->first;
  EXPECT_EQ(first % 4096, 0u);
  for (std::uint32_t i = first; i + 1 < first + 4096; ++i) {
    ASSERT_EQ(steps_between<2>(at.at(i), at.at(i + 1)), 1) << i;
  }
}

TEST(HilbertGrid, in_space_walks_through_the_finest_cells) {
  const HilbertGrid<3> grid = grid_of_side<3>(1024);
  std::map<std::uint32_t, Cell<3>> at;
  for (Cell<3> cell : cells_of<3>(16)) {
    cell = {cell[0] + 16 * 41, cell[1] + 16 * 63, cell[2] + 16 * 6};
    at[grid.distance(centre_of(cell))] = cell;
  }
  ASSERT_EQ(at.size(), 4096u);
  const std::uint32_t first = at.begin()->first;
  EXPECT_EQ(first % 4096, 0u);
  for (std::uint32_t i = first; i + 1 < first + 4096; ++i) {
    ASSERT_EQ(steps_between<3>(at.at(i), at.at(i + 1)), 1) << i;
  }
}

TEST(HilbertGrid, goes_from_the_low_corner_to_the_end_of_x) {
  const HilbertGrid<2> plane({-1, -1}, {1, 1});
  EXPECT_EQ(plane.distance({-1, -1}), 0u);
  EXPECT_EQ(plane.distance({1, -1}), 0xFFFFFFFFu);
  const HilbertGrid<3> space({-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(space.distance({-1, -1, -1}), 0u);
  EXPECT_EQ(space.distance({1, -1, -1}), 0x3FFFFFFFu);
}

TEST(HilbertGrid, has_square_cells_in_a_long_box) {
  const HilbertGrid<2> square({0, 0}, {64, 64});
  const HilbertGrid<2> flat({0, 0}, {64, 3});
  for (const Cell<2>& cell : cells_of<2>(64)) {
    if (cell[1] >= 3) continue;
    ASSERT_EQ(flat.distance(centre_of(cell)), square.distance(centre_of(cell)));
  }
}

TEST(HilbertGrid, divides_what_has_a_length_that_doubles_can_say) {
  EXPECT_FALSE(HilbertGrid<2>({5, 5}, {5, 5}).divides());
  EXPECT_FALSE(HilbertGrid<2>({0, 0}, {0, DBL_TRUE_MIN}).divides());
  EXPECT_FALSE(HilbertGrid<3>({0, 0, -DBL_MAX}, {0, 0, DBL_MAX}).divides());
  for (const double length : {1e-303, 1e-60, 1.0, 1e60, DBL_MAX}) {
    const HilbertGrid<2> grid({0, 0}, {0, length});
    EXPECT_TRUE(grid.divides()) << length;
    EXPECT_NE(grid.distance({0, 0}) >> 30, grid.distance({0, length}) >> 30) << length;
  }
  const double next = std::nextafter(1e15, 2e15);
  const HilbertGrid<3> ulp({1e15, 0, 0}, {next, 0, 0});
  EXPECT_NE(ulp.distance({1e15, 0, 0}) >> 27, ulp.distance({next, 0, 0}) >> 27);
}

TEST(HilbertDistance, of_a_box_without_width_or_height_stands) {
  EXPECT_EQ(hilbert_distance({{5, 5}, {5, 5}}, {5, 5}), hilbert_distance({{7, 5}, {7, 5}}, {7, 5}));
  EXPECT_LT(hilbert_distance({{5, 0}, {5, 1}}, {5, 0.2}),
            hilbert_distance({{5, 0}, {5, 1}}, {5, 0.8}));
}

TEST(HilbertDistance, is_the_grid_s_over_the_box) {
  const Box box{{-1, 2}, {5, 4}};
  const HilbertGrid<2> grid({-1, 2}, {5, 4});
  for (const Point p : {Point{0, 3}, Point{4.9, 2.1}, Point{-1, 4}}) {
    EXPECT_EQ(hilbert_distance(box, p), grid.distance(p));
  }
}

}  // namespace
}  // namespace thiessen
