#include "basin/cell_clipper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "basin/shapes.h"
#include "diagram/plane_diagram.h"
#include "tessellation/families.h"

namespace thiessen {
namespace {

using Areas = std::map<std::size_t, double>;

Areas areas_in(const std::vector<Point>& places, const Basin& basin, const Box& frame) {
  const Diagram diagram = plane_diagram(places, frame);
  const PlaneSurface plane;
  Areas areas;
  for (const CellShare& share : CellClipper(diagram, plane).shares(basin))
    areas[index(share.place)] = share.area;
  return areas;
}

Areas areas_in(const std::vector<Point>& places, const MultiPolygon& shape) {
  return areas_in(places, shapes::basin(shape), shapes::box_of(shape));
}

const MultiPolygon square{{shapes::rectangle({0, 0}, {25, 25}), {}}};

TEST(CellShares, of_one_place_are_the_basin) {
  EXPECT_EQ(areas_in({{99, -7}}, square), (Areas{{0, 625}}));
}

TEST(CellShares, of_two_places_are_its_two_sides) {
  EXPECT_EQ(areas_in({{0, 12.5}, {20, 12.5}}, square), (Areas{{0, 250}, {1, 375}}));
}

// Graduate Aptitude Test in Engineering 2017, civil engineering: gauges in the four corners and the
// middle of a square; the middle weighs a half and each corner an eighth.
TEST(CellShares, of_a_square_s_corners_and_centre) {
  EXPECT_EQ(areas_in({{0, 0}, {25, 0}, {25, 25}, {0, 25}, {12.5, 12.5}}, square),
            (Areas{{0, 78.125}, {1, 78.125}, {2, 78.125}, {3, 78.125}, {4, 312.5}}));
}

TEST(CellShares, of_places_on_a_line_are_strips) {
  std::vector<Point> places;
  for (int i = 0; i < 50; ++i) places.push_back({i + 0.5, i + 0.5});
  const Areas found = areas_in(places, square);
  // The strip of place i lies between x + y = 2 i and 2 i + 2; below x + y = s lies a triangle, or
  // the square less one.
  const auto below = [](double s) { return s <= 25 ? s * s / 2 : 625 - (50 - s) * (50 - s) / 2; };
  ASSERT_EQ(found.size(), 25u);
  for (const auto& [place, area] : found) {
    const double low = place == 0 ? 0 : 2.0 * static_cast<double>(place);
    EXPECT_EQ(area, below(low + 2) - below(low)) << place;
  }
}

// d3-delaunay's tests: the midpoint of the long side is the circle's centre.
TEST(CellShares, of_a_right_triangle_meet_in_the_middle_of_its_long_side) {
  const MultiPolygon box{{shapes::rectangle({-1, -1}, {2, 2}), {}}};
  EXPECT_EQ(areas_in({{0, 0}, {1, 0}, {0, 1}}, box), (Areas{{0, 2.25}, {1, 3.375}, {2, 3.375}}));
}

TEST(CellShares, of_a_lattice_are_equal) {
  std::vector<Point> places;
  for (int x = 0; x < 20; ++x) {
    for (int y = 0; y < 20; ++y) places.push_back({x + 0.5, y + 0.5});
  }
  const Areas areas = areas_in(places, {{shapes::rectangle({0, 0}, {20, 20}), {}}});
  ASSERT_EQ(areas.size(), 400u);
  for (const auto& [place, area] : areas) EXPECT_EQ(area, 1) << place;
}

TEST(CellShares, of_places_an_ulp_apart_are_two_halves) {
  const Point p{0.5, 0.5};
  const Point q{std::nextafter(0.5, 1), 0.5};
  const Areas areas = areas_in({p, q}, {{shapes::rectangle({0, 0}, {1, 1}), {}}});
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_NEAR(areas.at(0), 0.5, 1e-15);
  EXPECT_NEAR(areas.at(0) + areas.at(1), 1, 1e-15);
}

TEST(CellShares, of_a_basin_with_holes_and_islands) {
  const MultiPolygon shape{
      {shapes::rectangle({0, 0}, {8, 8}), {shapes::reversed(shapes::rectangle({2, 2}, {6, 6}))}},
      {shapes::rectangle({3, 3}, {5, 5}), {}}};
  // The border x = 3 leaves 3 by 8 less 1 by 4 on its left, and touches the island's side.
  EXPECT_EQ(areas_in({{1, 4}, {5, 4}}, shape), (Areas{{0, 20}, {1, 32}}));
}

TEST(CellShares, of_a_basin_whose_edge_runs_along_a_cell_s) {
  EXPECT_EQ(areas_in({{0, 0}, {2, 0}}, {{shapes::rectangle({1, -1}, {3, 1}), {}}}),
            (Areas{{1, 4}}));
  EXPECT_EQ(areas_in({{0, 0}, {2, 0}}, {{shapes::rectangle({-1, -1}, {1, 1}), {}}}),
            (Areas{{0, 4}}));
}

TEST(CellShares, of_an_edge_s_bulges_go_to_the_cells_along_it) {
  Basin basin = shapes::basin({{shapes::rectangle({0, 0}, {4, 2}), {}}});
  basin.bulges = {{0.8, 0, 0, 0}};  // the lower edge bulges outwards
  const Areas areas = areas_in({{1, 1}, {3, 1}}, basin, shapes::box_of(basin.shape));
  EXPECT_NEAR(areas.at(0), 4.4, 1e-14);
  EXPECT_NEAR(areas.at(1), 4.4, 1e-14);
  EXPECT_NEAR(area_of(basin, PlaneSurface()), 8.8, 1e-14);
}

// The third place's cell lies below the borders y = (2 x - 3) / 4 and y = (5 - 2 x) / 4. With the
// basin's lower edge it makes a triangle of base 1 and height 1 / 4, 0.125, of which 0.44 are cut
// off by the part of the bulge along its base, 0.367 of 1.2.
TEST(CellShares, of_an_edge_that_bends_away_from_a_cell_leave_that_cell_nothing) {
  Basin basin = shapes::basin({{shapes::rectangle({0, 0}, {4, 2}), {}}});
  basin.bulges = {{-1.2, 0, 0, 0}};  // the lower edge bulges inwards
  const std::vector<Point> places{{1, 1}, {3, 1}, {2, -1}};
  const Areas areas = areas_in(places, basin, shapes::box_of(basin.shape));
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_NEAR(areas.at(0), 3.4, 1e-14);
  EXPECT_NEAR(areas.at(1), 3.4, 1e-14);
  const Diagram diagram = plane_diagram(places, shapes::box_of(basin.shape));
  const PlaneSurface plane;
  const std::vector<ClippedCell> cells = CellClipper(diagram, plane).cells(basin);
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_NEAR(cells[0].area, 3.4, 1e-14);
}

TEST(CellShapes, share_their_edges_vertex_for_vertex) {
  const std::vector<Point> places{{1, 1}, {3, 1}, {2, 3}};
  const Basin basin = shapes::basin({{shapes::rectangle({0, 0}, {4, 4}), {}}});
  const Diagram diagram = plane_diagram(places, shapes::box_of(basin.shape));
  const PlaneSurface plane;
  const std::vector<ClippedCell> cells = CellClipper(diagram, plane).cells(basin);
  ASSERT_EQ(cells.size(), 3u);
  // They meet in (2, 1.75): as far from (1, 1) as from (2, 3), 1.25.
  for (const ClippedCell& cell : cells) {
    ASSERT_EQ(cell.shape.size(), 1u);
    EXPECT_EQ(std::count(cell.shape[0].outer.begin(), cell.shape[0].outer.end(), (Point{2, 1.75})),
              1);
  }
}

TEST(CellShapes, fall_in_pieces_where_the_basin_does) {
  // A U whose base belongs to the second place.
  const Ring u{{0, 0}, {6, 0}, {6, 6}, {4, 6}, {4, 2}, {2, 2}, {2, 6}, {0, 6}};
  const Diagram diagram =
      plane_diagram(std::vector<Point>{{3, 6}, {3, 0}}, shapes::box_of({{u, {}}}));
  const PlaneSurface plane;
  const std::vector<ClippedCell> cells =
      CellClipper(diagram, plane).cells(shapes::basin({{u, {}}}));
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(cells[0].shape.size(), 2u);
  EXPECT_EQ(cells[0].area, 12);
  EXPECT_EQ(cells[1].shape.size(), 1u);
  EXPECT_EQ(cells[1].area, 16);
}

TEST(CellClipper, gives_the_same_for_a_basin_again_and_after_another) {
  Seeded seeded;
  std::vector<Point> places(40);
  for (Point& p : places) p = {seeded.uniform(0, 1), seeded.uniform(0, 1)};
  const Diagram diagram = plane_diagram(places, {{0, 0}, {1, 1}});
  const PlaneSurface plane;
  CellClipper clipper(diagram, plane);
  const Basin star = shapes::basin({{shapes::star(seeded, {0.5, 0.5}, 0.5, 30), {}}});
  const Basin other = shapes::basin({{shapes::star(seeded, {0.4, 0.6}, 0.3, 30), {}}});
  const std::vector<CellShare> first = clipper.shares(star);
  clipper.shares(other);
  clipper.cells(other);
  const std::vector<CellShare> again = clipper.shares(star);
  ASSERT_EQ(again.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(again[i].area, first[i].area);
}

/// Stars about some of the places.
std::vector<Basin> basins_among(Seeded& seeded, const std::vector<Point>& places, const Box& box) {
  std::vector<Basin> basins;
  const double size = std::max(box.width(), box.height());
  for (int i = 0; i < 4; ++i) {
    const Point about = places[seeded.below(places.size())];
    basins.push_back(shapes::basin(
        {{shapes::star(seeded, about, size * std::pow(10, seeded.uniform(-2.5, -0.8)), 30), {}}}));
  }
  return basins;
}

Box box_of_all(const std::vector<Basin>& basins) {
  Box box;
  for (const Basin& basin : basins) box.take_in(shapes::box_of(basin.shape));
  return box;
}

// Bit for bit.
TEST(CellClipper, law_1_gives_the_same_of_a_diagram_that_has_only_what_the_basins_need) {
  Seeded seeded;
  const PlaneSurface plane;
  for (const Family& family : families::all(seeded, 700)) {
    SCOPED_TRACE(family.name);
    std::vector<Point> places = family.points;
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    Box box;
    for (const Point p : places) box.take_in(p);
    const double magnitude = std::max(
        {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
    if (std::max(box.width(), box.height()) < 1e-6 * magnitude) continue;  // no valid stars
    const std::vector<Basin> basins = basins_among(seeded, places, box);
    PlaneNeeds needs{.ground = {}, .neighbours = false, .near_is_seldom = true};
    for (const Basin& basin : basins) needs.ground.push_back(&basin.shape);
    const Diagram whole = plane_diagram(places, box_of_all(basins));
    const Diagram needed = plane_diagram(places, box_of_all(basins), needs);
    EXPECT_LE(needed.chords.size(), whole.chords.size());
    EXPECT_TRUE(needed.neighbours.empty());
    CellClipper of_whole(whole, plane);
    CellClipper of_needed(needed, plane);
    for (const Basin& basin : basins) {
      const std::vector<ClippedCell> expected = of_whole.cells(basin);
      const std::vector<ClippedCell> found = of_needed.cells(basin);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i].place, expected[i].place);
        ASSERT_EQ(found[i].area, expected[i].area);
        ASSERT_EQ(found[i].shape.size(), expected[i].shape.size());
        for (std::size_t part = 0; part < found[i].shape.size(); ++part) {
          ASSERT_EQ(found[i].shape[part].outer, expected[i].shape[part].outer);
          ASSERT_EQ(found[i].shape[part].holes, expected[i].shape[part].holes);
        }
      }
    }
  }
}

// The nearest place is found without the tessellation, by the same rule.
TEST(CellClipper, law_2_finds_the_cell_round_a_small_basin_where_near_is_seldom) {
  Seeded seeded;
  const PlaneSurface plane;
  const std::vector<Point> places = families::uniform(seeded, 2000);
  std::vector<Basin> basins;
  for (int i = 0; i < 8; ++i) {
    const Point about{seeded.uniform(0, 1), seeded.uniform(0, 1)};
    basins.push_back(shapes::basin({{shapes::star(seeded, about, 1e-4, 12), {}}}));
  }
  const Diagram whole = plane_diagram(places, box_of_all(basins));
  PlaneNeeds needs{.ground = {}, .neighbours = false, .near_is_seldom = true};
  for (const Basin& basin : basins) needs.ground.push_back(&basin.shape);
  const Diagram needed = plane_diagram(places, box_of_all(basins), needs);
  EXPECT_LT(needed.chords.size(), whole.chords.size() / 2);
  CellClipper of_whole(whole, plane);
  CellClipper of_needed(needed, plane, Searches::few);
  for (const Basin& basin : basins) {
    const std::vector<CellShare> expected = of_whole.shares(basin);
    const std::vector<CellShare> found = of_needed.shares(basin);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].place, expected[i].place);
      EXPECT_EQ(found[i].area, expected[i].area);
    }
  }
}

TEST(CellShapes, of_a_border_that_ends_within_the_basin_are_refused) {
  Diagram diagram = plane_diagram(std::vector<Point>{{5, 12}, {20, 12}}, shapes::box_of(square));
  ASSERT_EQ(diagram.chords.size(), 1u);
  const PlaneSurface plane;
  EXPECT_EQ(CellClipper(diagram, plane).cells(shapes::basin(square)).size(), 2u);
  for (Point& node : diagram.nodes) node.y = std::min(node.y, 10.0);
  EXPECT_THROW(CellClipper(diagram, plane).cells(shapes::basin(square)), std::logic_error);
}

}  // namespace
}  // namespace thiessen
