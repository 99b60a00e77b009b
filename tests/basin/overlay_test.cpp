// What a basin's overlay with cells gives, by what must hold of the pieces, and by half-planes.
#include "basin/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "basin/containment.h"
#include "basin/laid_basins.h"
#include "diagram/plane_diagram.h"
#include "oracles/half_planes.h"

namespace thiessen {
namespace {

/// All pieces of a basin, those of whole chords after the others.
CutBasin with_whole_chords(CutBasin cut, const Diagram& diagram) {
  for (const std::uint32_t chord : cut.whole_chords) {
    const auto [left, right] = pieces_of(diagram, chord);
    cut.pieces.push_back(left);
    cut.pieces.push_back(right);
  }
  return cut;
}

/// Calls `look` with the pieces of each.
template <typename Look>
void for_each_cut(Look&& look) {
  for (const shapes::Laid& laid : shapes::laid_in_many_ways()) {
    const Diagram diagram = plane_diagram(laid.places, shapes::box_of(laid.basin.shape));
    Overlay overlay(diagram);
    look(laid, with_whole_chords(overlay.cut(laid.basin), diagram));
  }
}

double shoelace(Point a, Point b) {
  return (a.x * b.y - a.y * b.x) / 2;
}

/// Calls `visit(from, to)` for every edge.
template <typename Visit>
void for_each_edge(const MultiPolygon& shape, Visit&& visit) {
  const auto go_round = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  };
  for (const Polygon& part : shape) {
    go_round(part.outer);
    for (const Ring& hole : part.holes) go_round(hole);
  }
}

TEST(Overlay, law_1_at_every_point_as_many_pieces_of_a_cell_begin_as_end) {
  for_each_cut([](const shapes::Laid&, const CutBasin& cut) {
    std::map<std::pair<PlaceIndex, Point>, int> open;
    for (const BoundaryPiece& piece : cut.pieces) {
      ASSERT_NE(piece.from, piece.to);
      ++open[{piece.place, piece.from}];
      --open[{piece.place, piece.to}];
    }
    for (const auto& [at, count] : open) ASSERT_EQ(count, 0) << at.second.x << ' ' << at.second.y;
  });
}

// Between two cells pieces lie on each other, bit for bit; what is left is the basin's own edge.
TEST(Overlay, law_2_all_cells_pieces_together_are_the_basins_edge) {
  for_each_cut([](const shapes::Laid& laid, const CutBasin& cut) {
    std::map<std::pair<Point, Point>, int> left;
    for (const BoundaryPiece& piece : cut.pieces) {
      const bool is_forward = piece.from < piece.to;
      left[std::minmax(piece.from, piece.to)] += is_forward ? 1 : -1;
    }
    double area = 0;
    double length = 0;
    for (const auto& [ends, count] : left) {
      ASSERT_LE(std::abs(count), 1);
      if (count == 0) continue;
      area += count * shoelace(ends.first, ends.second);
      length += std::hypot(ends.second.x - ends.first.x, ends.second.y - ends.first.y);
    }
    for_each_edge(laid.basin.shape, [&](Point from, Point to) {
      area -= shoelace(from, to);
      length -= std::hypot(to.x - from.x, to.y - from.y);
    });
    EXPECT_NEAR(area, 0, 1e-12);
    EXPECT_NEAR(length, 0, 1e-11);
  });
}

TEST(Overlay, law_3_no_place_is_nearer_to_a_cells_pieces_than_its_own) {
  for_each_cut([](const shapes::Laid& laid, const CutBasin& cut) {
    for (const BoundaryPiece& piece : cut.pieces) {
      const Point middle{(piece.from.x + piece.to.x) / 2, (piece.from.y + piece.to.y) / 2};
      const auto distance = [&](Point p) { return std::hypot(p.x - middle.x, p.y - middle.y); };
      double least = HUGE_VAL;
      for (const Point p : laid.places) least = std::min(least, distance(p));
      ASSERT_LE(distance(laid.places[index(piece.place)]), least + 1e-12);
    }
  });
}

TEST(Overlay, law_4_a_cells_pieces_enclose_what_half_planes_leave_of_the_basin) {
  for_each_cut([](const shapes::Laid& laid, const CutBasin& cut) {
    std::vector<double> areas(laid.places.size(), 0);
    for (const BoundaryPiece& piece : cut.pieces)
      areas[index(piece.place)] += shoelace(piece.from, piece.to);
    const Box box = shapes::box_of(laid.basin.shape).grown(1);
    for (std::size_t p = 0; p < laid.places.size(); ++p) {
      ASSERT_NEAR(areas[p], half_planes::common_area(laid.places, p, box, laid.basin.shape), 1e-10);
    }
  });
}

TEST(Overlay, law_5_it_tells_where_an_edge_runs_along_a_cells) {
  for_each_cut(
      [](const shapes::Laid& laid, const CutBasin& cut) { EXPECT_EQ(cut.touching, laid.along); });
}

// Those of chords count on either side, so that they cancel in the sum.
TEST(Overlay, law_6_bulges_of_edges_are_shared_and_those_of_chords_only_change_sides) {
  Seeded seeded;
  for (shapes::Laid& laid : shapes::laid_in_many_ways()) {
    double sum = 0;
    const auto add = [&](const Ring& ring) {
      std::vector<double>& bulges = laid.basin.bulges.emplace_back();
      for (std::size_t i = 0; i < ring.size(); ++i) bulges.push_back(seeded.uniform(-1, 1));
      sum = std::accumulate(bulges.begin(), bulges.end(), sum);
    };
    for (const Polygon& part : laid.basin.shape) {
      add(part.outer);
      for (const Ring& hole : part.holes) add(hole);
    }
    Diagram diagram = plane_diagram(laid.places, shapes::box_of(laid.basin.shape));
    for (std::size_t i = 0; i < diagram.chords.size(); ++i)
      diagram.bulges.push_back(seeded.uniform(-1, 1));
    Overlay overlay(diagram);
    double found = 0;
    const CutBasin cut = with_whole_chords(overlay.cut(laid.basin), diagram);
    for (const BoundaryPiece& piece : cut.pieces) found += piece.bulge;
    EXPECT_NEAR(found, sum, 1e-11);
  }
}

TEST(Overlay, law_7_a_basin_is_cut_the_same_after_any_other) {
  Seeded seeded;
  const std::vector<Point> places = shapes::lattice(8);
  const Diagram diagram = plane_diagram(places, {{0, 0}, {8, 8}});
  Overlay overlay(diagram);
  const Basin basin = shapes::basin({{shapes::star(seeded, {4, 4}, 3, 30), {}}});
  const CutBasin cut = overlay.cut(basin);
  const std::vector<BoundaryPiece>& first = cut.pieces;
  for (int i = 0; i < 10; ++i)
    overlay.cut(shapes::basin({{shapes::staircase(seeded, {1, 1}, 1, 6, 6), {}}}));
  const CutBasin& again = overlay.cut(basin);
  EXPECT_FALSE(again.touching);
  EXPECT_EQ(again.whole_chords, cut.whole_chords);
  ASSERT_EQ(again.pieces.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(again.pieces[i].place, first[i].place);
    EXPECT_EQ(again.pieces[i].from, first[i].from);
    EXPECT_EQ(again.pieces[i].to, first[i].to);
  }
}

TEST(Overlay, law_8_only_chords_that_lie_in_the_basin_from_end_to_end_are_whole) {
  for (const shapes::Laid& laid : shapes::laid_in_many_ways()) {
    const Diagram diagram = plane_diagram(laid.places, shapes::box_of(laid.basin.shape));
    const Containment within(laid.basin);
    Overlay overlay(diagram);
    const CutBasin& cut = overlay.cut(laid.basin);
    EXPECT_TRUE(!cut.touching || cut.whole_chords.empty());
    for (const std::uint32_t chord : cut.whole_chords) {
      EXPECT_TRUE(within.contains(diagram.nodes[diagram.chords[chord].from]));
      EXPECT_TRUE(within.contains(diagram.nodes[diagram.chords[chord].to]));
    }
  }
}

// Two cells whose border is x = 1, and a basin of 4 by 2 whose lower edge bends like a parabola. Up
// to a quarter of its way lie 5 / 32 of the bulge: (1 / 4)^2 (3 - 2 / 4).
TEST(Overlay, of_a_rectangle_over_two_cells) {
  const std::vector<Point> places{{0, 1}, {2, 1}};
  Basin basin = shapes::basin({{shapes::rectangle({0, 0}, {4, 2}), {}}});
  basin.bulges = {{32, 0, 0, 0}};
  const Diagram diagram = plane_diagram(places, shapes::box_of(basin.shape));
  Overlay overlay(diagram);
  std::map<std::pair<Point, Point>, std::size_t> found;
  for (const BoundaryPiece& piece : overlay.cut(basin).pieces) {
    found[{piece.from, piece.to}] = index(piece.place);
    const double bulge = piece.from.y != 0 || piece.to.y != 0 ? 0 : piece.from.x == 0 ? 5 : 27;
    EXPECT_NEAR(piece.bulge, bulge, 1e-13);
  }
  const decltype(found) expected{
      {{{0, 0}, {1, 0}}, 0}, {{{1, 0}, {1, 2}}, 0}, {{{1, 2}, {0, 2}}, 0}, {{{0, 2}, {0, 0}}, 0},
      {{{1, 0}, {4, 0}}, 1}, {{{4, 0}, {4, 2}}, 1}, {{{4, 2}, {1, 2}}, 1}, {{{1, 2}, {1, 0}}, 1}};
  EXPECT_EQ(found, expected);
}

TEST(Overlay, of_a_basin_within_one_cell_is_the_basin) {
  const std::vector<Point> places{{0, 0}, {10, 0}, {0, 10}};
  const Ring ring = shapes::rectangle({9, 0}, {11, 2});
  const Diagram diagram = plane_diagram(places, {{-1, -1}, {12, 12}});
  Overlay overlay(diagram);
  const CutBasin& cut = overlay.cut(shapes::basin({{ring, {}}}));
  ASSERT_EQ(cut.pieces.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(cut.pieces[i].place, PlaceIndex{1});
    EXPECT_EQ(cut.pieces[i].from, ring[i]);
    EXPECT_EQ(cut.pieces[i].to, ring[(i + 1) % 4]);
  }
}

}  // namespace
}  // namespace thiessen
