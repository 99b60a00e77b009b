#include "results/cell_measures_file.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "results/written.h"

namespace thiessen {
namespace {

template <int Dimension>
std::string cells_of(const std::vector<PositionIn<Dimension>>& points) {
  Tessellation<Dimension> tessellation;
  const std::vector<PointId> ids = tessellation.add_all(points);
  const NumberOf number_of = [&](PointId p) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (ids[i] == p) return std::uint64_t{10 * i + 1};
    }
    return std::uint64_t{0};
  };
  return written(
      [&](OutputFile& file) { write_cell_measures<Dimension>(file, tessellation, number_of); });
}

// The cell of the middle is the square between the middles of the sides.
TEST(CellMeasuresFile, of_a_square_and_its_middle) {
  EXPECT_EQ(cells_of<2>({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}}),
            "point,area,sides\n1,inf,3\n11,inf,3\n21,inf,3\n31,inf,3\n41,2,4\n");
}

// Nine points of a lattice: the middle one touches those across corners, and borders four.
TEST(CellMeasuresFile, counts_no_side_of_length_zero) {
  std::vector<Point> points;
  for (int i = 0; i < 9; ++i) points.push_back({2.0 * (i % 3), 2.0 * (i / 3)});
  const std::string text = cells_of<2>(points);
  EXPECT_NE(text.find("\n41,4,4\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n1,inf,2\n"), std::string::npos) << text;
}

// Of 27 points of a lattice the middle one has a cube of edge 2.
TEST(CellMeasuresFile, of_a_cube) {
  std::vector<SpacePoint> points;
  for (int i = 0; i < 27; ++i) points.push_back({2.0 * (i % 3), 2.0 * (i / 3 % 3), 2.0 * (i / 9)});
  const std::string text = cells_of<3>(points);
  EXPECT_TRUE(text.starts_with("point,volume,sides\n1,inf,3\n")) << text;
  EXPECT_NE(text.find("\n131,8,6\n"), std::string::npos) << text;
}

TEST(CellMeasuresFile, of_a_line_a_point_and_none) {
  EXPECT_EQ(cells_of<2>({{0, 0}, {1, 0}, {2, 0}}),
            "point,area,sides\n1,inf,1\n11,inf,2\n21,inf,1\n");
  EXPECT_EQ(cells_of<3>({{0, 0, 0}}), "point,volume,sides\n1,inf,0\n");
  EXPECT_EQ(cells_of<2>({}), "point,area,sides\n");
}

}  // namespace
}  // namespace thiessen
