#include "map/raster/rival_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/predicates.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

// A plane whose columns run east and whose rows run south, a unit wide.
constexpr PixelPlane pixels{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, 0};
constexpr PixelBlock block{0, 0, 40, 30};

struct Rivals {
  std::vector<Point> positions;
  std::vector<PlaceIndex> indices;

  std::size_t nearest(Point p) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < positions.size(); ++i) {
      if (compare_distance(p, positions[i], positions[best]) < 0) best = i;
    }
    return best;
  }
};

Rivals random_rivals(Seeded& seeded) {
  Rivals rivals;
  for (std::uint64_t k = 2 + seeded.below(RivalCells::most - 2); k-- > 0;) {
    rivals.indices.push_back(PlaceIndex{static_cast<std::uint32_t>(rivals.positions.size())});
    rivals.positions.push_back({seeded.uniform(-20, 60), seeded.uniform(-50, 20)});
  }
  return rivals;
}

// Every centre lies in the cell of its nearest rival.
TEST(RivalCells, hold_the_centres_that_they_are_nearest_to) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(200); ++round) {
    const Rivals rivals = random_rivals(seeded);
    const auto places = nearest_places(rivals.positions, Metric::planar);
    RivalCells cells;
    ASSERT_TRUE(cells.lay(pixels, block, *places, rivals.indices));
    double area = 0;
    for (const RivalCells::Cell& cell : cells.cells()) area += cell.doubled_area() / 2;
    EXPECT_NEAR(area, 41 * 31, 1e-9);
    for (int row = 0; row < block.rows; ++row) {
      for (int column = 0; column < block.columns; ++column) {
        const std::size_t nearest =
            rivals.nearest({static_cast<double>(column), -static_cast<double>(row)});
        const auto cell =
            std::find_if(cells.cells().begin(), cells.cells().end(),
                         [&](const RivalCells::Cell& c) { return c.rival == nearest; });
        ASSERT_NE(cell, cells.cells().end());
        for (std::size_t i = 0; i < cell->count; ++i) {
          const Point a = cell->corners[i];
          const Point b = cell->next(i);
          ASSERT_GE((b.x - a.x) * (row - a.y) - (b.y - a.y) * (column - a.x), -1e-9);
        }
      }
    }
  }
}

// Along an edge every centre's nearest rival is told.
TEST(RivalCells, tell_the_nearest_along_edges) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(200); ++round) {
    const Rivals rivals = random_rivals(seeded);
    const auto places = nearest_places(rivals.positions, Metric::planar);
    RivalCells cells;
    ASSERT_TRUE(cells.lay(pixels, block, *places, rivals.indices));
    for (std::size_t i = 0; i < cells.cells().size(); ++i) {
      const RivalCells::Cell& cell = cells.cells()[i];
      for (std::size_t k = 0; k < cell.count; ++k) {
        if (cell.beyond[k] == RivalCells::nobody) continue;
        const RivalCells::Edge edge(cells, i, cell.beyond[k], cell.corners[k], cell.next(k), 0.6);
        const Point middle{(cell.corners[k].x + cell.next(k).x) / 2,
                           (cell.corners[k].y + cell.next(k).y) / 2};
        const int column = static_cast<int>(std::lround(middle.x));
        const int row = static_cast<int>(std::lround(middle.y));
        if (column < 0 || column >= block.columns || row < 0 || row >= block.rows) continue;
        const auto nearest = edge.nearest(column, row);
        ASSERT_TRUE(nearest);
        ASSERT_EQ(edge.rival(*nearest), rivals.nearest({static_cast<double>(column), -1.0 * row}));
      }
    }
  }
}

TEST(RivalCells, do_not_tell_a_tie) {
  const Rivals rivals{{{10, 0}, {20, 0}}, {PlaceIndex{0}, PlaceIndex{1}}};
  const auto places = nearest_places(rivals.positions, Metric::planar);
  RivalCells cells;
  ASSERT_TRUE(cells.lay(pixels, block, *places, rivals.indices));
  const RivalCells::Edge edge(cells, 0, 1, {15, -1}, {15, 30}, 0.6);
  EXPECT_FALSE(edge.nearest(15, 7));
  EXPECT_EQ(edge.nearest(14, 7), 0U);
  EXPECT_EQ(edge.nearest(16, 7), 1U);
}

// Four places lie round a centre. The nearest and the second are opposite each other, 40.2 apart,
// where with positions 0.1 off a difference of 8.0 of the squares is certain; theirs is 7. The two
// others, whose edge comes near the centre, are no farther from either than 34.0, which would make
// 6.8 certain.
TEST(RivalCells, do_not_tell_the_nearest_of_two_beyond_an_edge_by_what_is_certain_along_it) {
  const Point centre{20, -15};
  Rivals rivals;
  const auto add = [&](double degrees, double square) {
    const double angle = degrees * M_PI / 180;
    rivals.indices.push_back(PlaceIndex{static_cast<std::uint32_t>(rivals.positions.size())});
    rivals.positions.push_back({centre.x + std::sqrt(square) * std::cos(angle),
                                centre.y + std::sqrt(square) * std::sin(angle)});
  };
  add(90, 400);
  add(-90, 407);
  add(10, 420);
  add(-10, 420);
  const auto places = nearest_places(rivals.positions, Metric::planar);
  PixelPlane off = pixels;
  off.off = 0.1;
  RivalCells cells;
  ASSERT_TRUE(cells.lay(off, block, *places, rivals.indices));
  bool is_asked = false;
  for (std::size_t i = 0; i < cells.cells().size(); ++i) {
    const RivalCells::Cell& cell = cells.cells()[i];
    for (std::size_t k = 0; k < cell.count; ++k) {
      if (cell.beyond[k] == RivalCells::nobody) continue;
      if (cell.rival < 2 || cells.cells()[cell.beyond[k]].rival < 2) continue;
      const RivalCells::Edge edge(cells, i, cell.beyond[k], cell.corners[k], cell.next(k), 0.6);
      ASSERT_EQ(edge.count(), 4U);
      EXPECT_FALSE(edge.nearest(20, 15));
      is_asked = true;
    }
  }
  EXPECT_TRUE(is_asked);
}

TEST(RivalCells, are_not_laid_where_the_plane_does_not_tell) {
  const Rivals rivals{{{10, 0}, {20, 0}}, {PlaceIndex{0}, PlaceIndex{1}}};
  const auto places = nearest_places(rivals.positions, Metric::planar);
  PixelPlane far_off = pixels;
  far_off.off = 0.2;
  RivalCells cells;
  EXPECT_FALSE(cells.lay(far_off, block, *places, rivals.indices));
  far_off.off = 0.1;
  EXPECT_TRUE(cells.lay(far_off, block, *places, rivals.indices));
}

}  // namespace
}  // namespace thiessen
