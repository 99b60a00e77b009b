// Cells clipped to basins, against GEOS and against areas in long doubles: each cell is cut out of
// a box by all bisectors, and intersected with the basin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "basin/cell_clipper.h"
#include "basin/shapes.h"
#include "diagram/plane_diagram.h"
#include "diagram/surface.h"
#include "oracles/geos.h"
#include "oracles/half_planes.h"
#include "tessellation/families.h"

namespace thiessen {
namespace {

using Edge = std::pair<Point, Point>;

double distance(Point a, Point b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

template <typename Visit>
void for_each_edge(const MultiPolygon& shape, Visit&& visit) {
  const auto ring_edges = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  };
  for (const Polygon& part : shape) {
    ring_edges(part.outer);
    for (const Ring& hole : part.holes) ring_edges(hole);
  }
}

std::vector<Point> without_repeats(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Every edge within the basin is one of two cells, in opposite directions; the others are the
/// basin's boundary.
void expect_shared_edges(const std::vector<ClippedCell>& cells, const MultiPolygon& basin) {
  std::map<Edge, int> count;
  for (const ClippedCell& cell : cells)
    for_each_edge(cell.shape, [&](Point a, Point b) { ++count[{a, b}]; });
  double boundary = 0;
  for (const auto& [edge, times] : count) {
    ASSERT_EQ(times, 1) << edge.first.x << " " << edge.first.y;
    if (!count.contains({edge.second, edge.first})) boundary += distance(edge.first, edge.second);
  }
  double perimeter = 0;
  for_each_edge(basin, [&](Point a, Point b) { perimeter += distance(a, b); });
  // Cells too small to count are gaps, with edges of their own.
  EXPECT_NEAR(boundary, perimeter, 1e-6 * perimeter);
}

/// What rounding a point on each edge may do to the area.
double rounding_of_edges(const MultiPolygon& shape) {
  const Box box = shapes::box_of(shape);
  const double largest = std::max(
      {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  double perimeter = 0;
  for_each_edge(shape, [&](Point a, Point b) { perimeter += distance(a, b); });
  return 0x1p-52 * largest * perimeter;
}

std::string text_of(const std::vector<Point>& points) {
  std::ostringstream text;
  text.precision(17);
  for (const Point p : points) text << "{" << p.x << ", " << p.y << "}, ";
  return text.str();
}

class Clipping : public testing::Test {
 protected:
  void check(const std::vector<Point>& places, const MultiPolygon& shape) {
    check_all(places, shape);
    if (!HasFailure() || places.size() > 1000) return;
    ADD_FAILURE() << "places " << text_of(places);
    for (const Polygon& part : shape) {
      ADD_FAILURE() << "outer " << text_of(part.outer);
      for (const Ring& hole : part.holes) ADD_FAILURE() << "hole " << text_of(hole);
    }
  }

  // Where nodes lie closer together than rounding, shapes may cross themselves there, and slivers
  // without a share may lie between cells.
  bool rounding_may_tangle_ = false;
  int not_valid_ = 0;

 private:
  void check_all(const std::vector<Point>& places, const MultiPolygon& shape) {
    const geos::Geometry basin_geometry = geos::geometry_of(shape);
    ASSERT_EQ(geos::reason_invalid(*basin_geometry), "") << "the test's own basin";
    const Basin basin = shapes::basin(shape);
    const Box frame = shapes::box_of(shape);
    const Diagram diagram = plane_diagram(places, frame);
    const PlaneSurface plane;
    CellClipper clipper(diagram, plane);
    const double whole = area_of(basin, plane);
    const double rounding = 1e-12 * whole + rounding_of_edges(shape);
    ASSERT_NEAR(whole, geos::area(*basin_geometry), 1e-11 * whole + rounding_of_edges(shape));

    const std::vector<CellShare> shares = clipper.shares(basin);
    const std::vector<ClippedCell> cells = clipper.cells(basin);
    double sum = 0;
    std::map<std::size_t, double> area_at;
    for (const CellShare& share : shares) {
      sum += share.area;
      EXPECT_GT(share.area, 0);
      area_at[index(share.place)] = share.area;
    }
    EXPECT_NEAR(sum, whole, rounding);
    expect_areas(places, shape, area_at, whole, rounding);
    ASSERT_EQ(cells.size(), shares.size());
    double cell_sum = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      ASSERT_EQ(cells[i].place, shares[i].place);
      ASSERT_EQ(cells[i].area, shares[i].area);
      const geos::Geometry cell = geos::geometry_of(cells[i].shape);
      EXPECT_NEAR(geos::area(*cell), cells[i].area, rounding);
      cell_sum += geos::area(*cell);
      const std::string reason = geos::reason_invalid(*cell);
      if (reason.empty()) continue;
      ++not_valid_;
      EXPECT_TRUE(rounding_may_tangle_) << reason;
      EXPECT_NEAR(geos::area(*geos::made_valid(*cell)), cells[i].area, rounding) << reason;
    }
    EXPECT_NEAR(cell_sum, whole, rounding);
    if (!rounding_may_tangle_) expect_shared_edges(cells, shape);
  }

  void expect_areas(const std::vector<Point>& places, const MultiPolygon& shape,
                    std::map<std::size_t, double>& area_at, double whole, double rounding) const {
    const geos::Geometry basin = geos::geometry_of(shape);
    const Box frame = shapes::box_of(shape);
    const Box box = frame.grown(std::max(frame.width(), frame.height()) / 8);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double expected = half_planes::common_area(places, i, box, shape);
      const double ours = area_at.contains(i) ? area_at[i] : 0;
      EXPECT_NEAR(ours, expected, 1e-12 * whole + 4 * rounding) << "place " << i;
      // GEOS 3.11 may find nothing where edges run beside each other, less than an ulp away.
      const Ring ring = half_planes::cell(places, i, box);
      if (rounding_may_tangle_ || ring.size() < 3) continue;
      const geos::Geometry rounded = geos::geometry_of({{ring, {}}});
      if (!geos::reason_invalid(*rounded).empty()) continue;
      EXPECT_NEAR(ours, geos::area(*geos::intersection(*rounded, *basin)), 1e-10 * whole + rounding)
          << "place " << i;
    }
  }
};

MultiPolygon star_with_hole(Seeded& seeded, Point centre, double radius) {
  const Ring outer = shapes::star(seeded, centre, radius, 5 + seeded.below(40));
  Polygon polygon{outer, {}};
  if (seeded.below(2) == 0)
    polygon.holes.push_back(shapes::reversed(shapes::scaled(outer, centre, 0.5)));
  MultiPolygon shape{polygon};
  if (!polygon.holes.empty() && seeded.below(2) == 0)  // an island in the lake
    shape.push_back({shapes::scaled(outer, centre, 0.2), {}});
  return shape;
}

bool is_finer_than_doubles(const Family& family) {
  for (const char* name :
       {"ulp", "far", "rounded circle", "rotated", "tenths", "302", "times", "and centre"}) {
    if (family.name.find(name) != std::string::npos) return true;
  }
  return false;
}

Box box_of_points(const std::vector<Point>& points) {
  Box box;
  for (const Point p : points) box.take_in(p);
  return box;
}

TEST_F(Clipping, stars_over_every_family) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(3); ++round) {
    for (const Family& family : families::all(seeded, 60)) {
      SCOPED_TRACE(family.name);
      rounding_may_tangle_ = is_finer_than_doubles(family);
      const std::vector<Point> places = without_repeats(family.points);
      const Box box = box_of_points(places);
      const double size = std::max({box.width(), box.height(), 1e-6 * std::abs(box.low.x)});
      const Point p = places[seeded.below(places.size())];
      const Point centre = seeded.below(2) == 0 ? p : box.centre();
      check(places, star_with_hole(seeded, centre, size * seeded.uniform(0.05, 1)));
      if (HasFailure()) return;
    }
  }
}

TEST_F(Clipping, basins_with_vertices_at_nodes_and_places) {
  Seeded seeded;
  rounding_may_tangle_ = true;  // an edge may run beside a chord, less than an ulp away
  for (std::uint64_t round = 0; round < seeded.rounds(3); ++round) {
    for (const Family& family : families::all(seeded, 60)) {
      SCOPED_TRACE(family.name);
      const std::vector<Point> places = without_repeats(family.points);
      const Box box = box_of_points(places);
      if (box.width() < 1e-9 * std::abs(box.low.x)) continue;  // no basin of whole ulps
      const Diagram diagram = plane_diagram(places, box);
      std::vector<Point> corners;
      for (int i = 0; i < 12; ++i) {
        corners.push_back(places[seeded.below(places.size())]);
        if (diagram.nodes.empty()) continue;
        corners.push_back(diagram.nodes[seeded.below(diagram.nodes.size())]);
      }
      const Point centre = diagram.nodes.empty() || seeded.below(2) == 0
                               ? box.centre()
                               : diagram.nodes[seeded.below(diagram.nodes.size())];
      const Ring ring = shapes::star_through(corners, centre);
      const geos::Geometry geometry =
          geos::geometry_of({{ring.empty() ? shapes::rectangle({0, 0}, {1, 1}) : ring, {}}});
      if (ring.empty() || !geos::reason_invalid(*geometry).empty()) continue;
      check(places, {{ring, {}}});
      if (HasFailure()) return;
    }
  }
  RecordProperty("not_valid", not_valid_);
}

// Every edge of the basin runs along edges of cells, and its corners are nodes.
TEST_F(Clipping, staircases_along_the_cells_of_a_lattice) {
  Seeded seeded;
  const std::vector<Point> places = families::lattice(100, 1, {0, 0}, 0);
  for (std::uint64_t round = 0; round < seeded.rounds(12); ++round) {
    const Ring stairs = shapes::staircase(seeded, {0.5, 0.5}, 1, 8, 8);
    check(places, {{stairs, {}}});
    const Basin basin = shapes::basin({{stairs, {}}});
    const Diagram diagram = plane_diagram(places, shapes::box_of(basin.shape));
    const PlaneSurface plane;
    for (const CellShare& share : CellClipper(diagram, plane).shares(basin))
      ASSERT_EQ(share.area, 1);
    // Through the places instead: quarters of cells.
    check(places, {{shapes::staircase(seeded, {1, 1}, 1, 7, 7), {}}});
    check(places, {{shapes::staircase(seeded, {0.5, 1}, 0.5, 16, 14), {}}});
    if (HasFailure()) return;
  }
}

TEST_F(Clipping, staircases_along_the_cells_of_a_lattice_in_tenths) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(8); ++round) {
    for (const Point origin : {Point{0, 0}, Point{500000, 4000000}}) {
      const std::vector<Point> places = families::lattice(100, 0.1, origin, 0);
      check(places,
            {{shapes::staircase(seeded, {origin.x + 0.05, origin.y + 0.05}, 0.1, 8, 8), {}}});
      check(places, {{shapes::staircase(seeded, {origin.x + 0.1, origin.y + 0.1}, 0.1, 7, 7), {}}});
      if (HasFailure()) return;
    }
  }
}

// A cell as a basin is all its own.
TEST_F(Clipping, cells_as_basins) {
  Seeded seeded;
  for (const Family& family : families::all(seeded, 40)) {
    SCOPED_TRACE(family.name);
    if (family.name.find("ulp") != std::string::npos) continue;  // cells of no whole ulp
    const std::vector<Point> places = without_repeats(family.points);
    const Box box = box_of_points(places);
    if (!(box.width() > 0) || !(box.height() > 0)) continue;
    const Diagram diagram = plane_diagram(places, box);
    const PlaneSurface plane;
    CellClipper clipper(diagram, plane);
    const Basin whole = shapes::basin({{shapes::rectangle(box.low, box.high), {}}});
    for (const ClippedCell& cell : clipper.cells(whole)) {
      if (!geos::reason_invalid(*geos::geometry_of(cell.shape)).empty()) continue;
      const std::vector<CellShare> shares = clipper.shares(shapes::basin(cell.shape));
      double own = 0;
      for (const CellShare& share : shares) {
        if (share.place == cell.place) own = share.area;
      }
      EXPECT_NEAR(own, cell.area, 1e-12 * cell.area + rounding_of_edges(whole.shape))
          << "cell at " << places[index(cell.place)].x << " " << places[index(cell.place)].y;
    }
  }
}

TEST_F(Clipping, a_comb_whose_cells_fall_in_many_pieces) {
  Seeded seeded;
  const Ring comb = shapes::comb({0, 0}, 1, 1, 60);
  check(families::uniform(seeded, 50), {{comb, {}}});
  check(families::lattice(100, 0.125, {0, 0}, 0), {{comb, {}}});
  check(families::line(17, {0, 0.0625}, {0, 0.0625}), {{comb, {}}});
}

TEST_F(Clipping, a_thousand_islands) {
  Seeded seeded;
  check(families::uniform(seeded, 100), shapes::islands(seeded, {0, 0}, 1.0 / 32, 32));
}

TEST_F(Clipping, a_basin_with_a_thousand_holes) {
  Seeded seeded;
  Polygon cheese{shapes::rectangle({0, 0}, {1, 1}), {}};
  for (const Polygon& island : shapes::islands(seeded, {0, 0}, 1.0 / 32, 32))
    cheese.holes.push_back(shapes::reversed(island.outer));
  check(families::uniform(seeded, 100), {cheese});
}

TEST_F(Clipping, a_snowflake_of_49152_vertices) {
  Seeded seeded;
  check(families::uniform(seeded, 60), {{shapes::snowflake({0.5, 0.5}, 0.6, 7), {}}});
}

TEST_F(Clipping, a_basin_far_from_every_place) {
  Seeded seeded;
  const std::vector<Point> places = families::uniform(seeded, 50);
  for (const Point far : {Point{1e3, 0}, Point{1e6, 1e6}, Point{-3e7, 2}}) {
    check(places, {{shapes::star(seeded, far, 10, 20), {}}});
    check(places, {{shapes::star(seeded, far, 1e5, 20), {}}});
  }
}

TEST_F(Clipping, basins_far_smaller_than_a_cell) {
  Seeded seeded;
  const std::vector<Point> places = families::lattice(25, 1, {0, 0}, 0);
  for (const Point centre : {Point{0.5, 0.5}, Point{0.5, 1}, Point{1, 1}, Point{3.5, 1.5}}) {
    for (const double size : {1e-3, 1e-9, 1e-13})
      check(places, {{shapes::rectangle({centre.x - size, centre.y - size},
                                        {centre.x + size, centre.y + size}),
                      {}}});
  }
}

// Rings that touch in a point, on a cell's edge and on a node.
TEST_F(Clipping, parts_and_holes_that_touch) {
  const std::vector<Point> places = families::lattice(25, 1, {0, 0}, 0);
  const Ring low = shapes::rectangle({0.25, 0.25}, {1.5, 1.5});
  const Ring high = shapes::rectangle({1.5, 1.5}, {3.25, 3.25});
  check(places, {{low, {}}, {high, {}}});
  const Ring shell = shapes::rectangle({0, 0}, {4, 4});
  const Ring lozenge{{1.5, 0}, {1, 1}, {0.5, 2}, {1, 2.5}};  // clockwise
  check(places, {{shell, {lozenge}}});
  check(places, {{shell, {shapes::reversed(low), shapes::reversed(high)}}});
}

}  // namespace
}  // namespace thiessen
