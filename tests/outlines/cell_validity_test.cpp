// Cells about to be written.
#include "outlines/cell_validity.h"

#include <gtest/gtest.h>

#include "outlines/polygon_validity.h"

namespace thiessen {
namespace {

MultiPolygon rectangle(double x, double y, double width, double height) {
  return {{{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, {}}};
}

const MultiPolygon needle = {
    {{{0, 0}, {4, 0}, {4, 2}, {6, 2}, {8, 2 + 1e-11}, {6, 2 - 1e-11}, {4, 2 + 1e-11}, {0, 2}}, {}}};

TEST(CellValidity, valid_cells_keep_their_bits) {
  CellShapes cells{{rectangle(0.1, 0.1, 1, 1), rectangle(1.1, 0.1, 1, 1)}, {0, 0}, 0};
  const std::vector<MultiPolygon> before = cells.shapes;
  EXPECT_TRUE(make_valid(cells, 1e-8).empty());
  EXPECT_EQ(cells.shapes[0][0].outer, before[0][0].outer);
  EXPECT_TRUE(round_cells(cells, 7).narrow().empty());
}

TEST(CellValidity, a_needle_of_one_basin_leaves_other_basins_alone) {
  CellShapes cells{{rectangle(1.0 / 3, -4, 1, 1), needle}, {0, 1}, 0};
  const Ring other = cells.shapes[0][0].outer;
  EXPECT_TRUE(make_valid(cells, 1e-8).empty());
  EXPECT_EQ(cells.shapes[0][0].outer, other);
  EXPECT_EQ(validity_fault(cells.shapes[1]), "");
  EXPECT_EQ(cells.collapsed, 1U);
}

TEST(CellValidity, what_is_narrower_than_a_tenth_of_the_last_decimal_is_collapsed) {
  CellShapes cells{
      {{{{{0, 0}, {4, 0}, {4, 2}, {6, 2}, {4, 2 + 1e-9}, {4, 4}, {0, 4}}, {}}}}, {0}, 0};
  EXPECT_TRUE(is_writable(cells.shapes[0]));
  const VertexRounding rounding = round_cells(cells, 7);
  EXPECT_TRUE(rounding.faulty().empty());
  EXPECT_EQ(plane_area(cells.shapes[0]), 16);
  EXPECT_EQ(cells.collapsed, 1U);
}

TEST(CellValidity, a_basin_that_is_narrower_than_that_is_kept) {
  CellShapes cells{{rectangle(0, 0, 1e-10, 1e-10)}, {0}, 0};
  const VertexRounding rounding = round_cells(cells, 7);
  EXPECT_TRUE(rounding.faulty().empty());
  EXPECT_GT(plane_area(cells.shapes[0]), 0);
}

TEST(CellValidity, a_cell_beyond_repair_is_told) {
  CellShapes cells{{{{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}}}}, {0}, 0};
  EXPECT_EQ(make_valid(cells, 1e-8), (std::vector<std::size_t>{0}));
  EXPECT_EQ(round_cells(cells, 7).faulty(), (std::vector<std::size_t>{0}));
}

TEST(CellValidity, the_finest_grid_follows_the_coordinates) {
  EXPECT_DOUBLE_EQ(finest_grid(std::vector<MultiPolygon>{rectangle(0, 0, 1e5, 3)}), 1e-6);
  EXPECT_EQ(finest_grid({}), 1);
}

}  // namespace
}  // namespace thiessen
