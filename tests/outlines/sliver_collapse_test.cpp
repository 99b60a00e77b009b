// Needles and slivers in cells that tile a basin.
#include "outlines/sliver_collapse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "outlines/polygon_validity.h"
#include "outlines/vertex_rounding.h"

namespace thiessen {
namespace {

using Edges = std::map<std::pair<Point, Point>, int>;

/// Directed edges less those that run the other way: the outline of all cells together.
Edges outline_of(const std::vector<MultiPolygon>& cells) {
  Edges edges;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      if (edges[{b, a}] > 0) {
        --edges[{b, a}];
      } else {
        ++edges[{a, b}];
      }
    }
  };
  for (const MultiPolygon& cell : cells) {
    for (const Polygon& polygon : cell) {
      add(polygon.outer);
      std::for_each(polygon.holes.begin(), polygon.holes.end(), add);
    }
  }
  std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
  return edges;
}

// A square with a needle to the east, cut in two; rounding made the needle's tip cross itself.
const MultiPolygon left = {{{{0, 0}, {2, 0}, {2, 4}, {0, 4}}, {}}};
const MultiPolygon right = {
    {{{2, 0}, {4, 0}, {4, 2}, {6, 2}, {8, 2.00001}, {6, 1.99999}, {4, 2.00001}, {4, 4}, {2, 4}},
     {}}};

TEST(SliverCollapse, a_needle_that_crosses_itself_goes) {
  ASSERT_NE(validity_fault(right), "");
  const std::vector<MultiPolygon> cells = {left, right};
  const auto after = collapsed(cells, 0.001);
  ASSERT_TRUE(after);
  EXPECT_EQ(validity_fault(after->at(1)), "");
  EXPECT_NEAR(plane_area(after->at(1)), 8, 0.01);
  EXPECT_EQ(plane_area(after->at(0)), 8);
}

TEST(SliverCollapse, cells_beside_each_other_stay_so) {
  const std::vector<MultiPolygon> cells = {left, right};
  const auto after = collapsed(cells, 0.001);
  ASSERT_TRUE(after);
  const Edges outline = outline_of(*after);
  EXPECT_FALSE(outline.contains({{2, 0}, {2, 4}}));
  EXPECT_FALSE(outline.contains({{2, 4}, {2, 0}}));
}

TEST(SliverCollapse, gauges_at_one_place_keep_their_common_shape) {
  const std::vector<MultiPolygon> cells = {right, left, right};
  const auto after = collapsed(cells, 0.001);
  ASSERT_TRUE(after);
  ASSERT_EQ(after->at(0).size(), 1U);
  EXPECT_EQ(after->at(0)[0].outer, after->at(2).at(0).outer);
}

TEST(SliverCollapse, vertices_to_which_nothing_falls_keep_their_bits) {
  const double odd = 1.0 / 3;
  const std::vector<MultiPolygon> cells = {
      {{{{odd, odd}, {4, odd}, {4, 4}, {8, 4}, {8, 4.0001}, {4, 4.0001}, {odd, 5}}, {}}}};
  const auto after = collapsed(cells, 0.01);
  ASSERT_TRUE(after);
  const Ring& ring = after->at(0).at(0).outer;
  EXPECT_NE(std::find(ring.begin(), ring.end(), Point{odd, odd}), ring.end());
  EXPECT_EQ(std::find(ring.begin(), ring.end(), Point{8, 4}), ring.end());
}

TEST(SliverCollapse, a_cell_that_is_narrower_as_a_whole_has_no_shape_left) {
  const std::vector<MultiPolygon> cells = {{{{{0, 0}, {4, 0}, {4, 0.001}, {0, 0.001}}, {}}},
                                           {{{{0, 0.001}, {4, 0.001}, {4, 4}, {0, 4}}, {}}}};
  const auto after = collapsed(cells, 0.1);
  ASSERT_TRUE(after);
  EXPECT_TRUE(after->at(0).empty());
  EXPECT_TRUE(is_writable(after->at(1)));
}

TEST(SliverCollapse, more_than_slivers_is_not_collapsed) {
  // Half of the square is covered twice.
  const std::vector<MultiPolygon> cells = {
      {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {}}, {{{2, 0}, {4, 0}, {4, 4}, {2, 4}}, {}}}};
  EXPECT_FALSE(collapsed(cells, 0.001));
}

}  // namespace
}  // namespace thiessen
