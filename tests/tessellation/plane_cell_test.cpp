#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

#include "tessellation/cells_of_points.h"

namespace thiessen {
namespace {

std::vector<Point> centres(const PlaneCell& cell) {
  std::vector<Point> centres;
  for (const auto& vertex : cell.vertices) centres.push_back(vertex.centre);
  return centres;
}
std::vector<Point> neighbours(const Tessellation<2>& tessellation, const PlaneCell& cell) {
  std::vector<Point> neighbours;
  for (const PointId q : cell.neighbours) neighbours.push_back(tessellation.position(q));
  return neighbours;
}

std::vector<Point> lattice(double x_step, double y_step, Point origin) {
  std::vector<Point> points;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) points.push_back({origin.x + i * x_step, origin.y + j * y_step});
  }
  return points;
}

TEST(PlaneCell, of_a_lattice_is_a_rectangle_whose_corners_are_said_once) {
  const auto tessellation = tessellation_of<2>(lattice(1, 2, {0, 0}));
  const PlaneCell cell = cell_at<2>(tessellation, {2, 4});
  EXPECT_TRUE(cell.is_bounded);
  EXPECT_EQ(cell.area, 2);
  EXPECT_EQ(centres(cell), (std::vector<Point>{{1.5, 3}, {2.5, 3}, {2.5, 5}, {1.5, 5}}));
  // The edge that ends at a vertex is its neighbour's.
  EXPECT_EQ(neighbours(tessellation, cell), (std::vector<Point>{{1, 4}, {2, 2}, {3, 4}, {2, 6}}));
  EXPECT_TRUE(cell.rays.empty());
}

TEST(PlaneCell, names_a_corner_by_the_simplex_whose_points_come_first) {
  const auto tessellation = tessellation_of<2>(lattice(1, 1, {0, 0}));
  const auto forming = [&](VertexId v) {
    std::set<Point> positions;
    for (const PointId p : tessellation.topology().forming(v))
      positions.insert(tessellation.position(p));
    return positions;
  };
  const PlaneCell cell = cell_at<2>(tessellation, {2, 2});
  Star<2> star;
  tessellation.find_star(cell.point, star);
  ASSERT_GT(star.vertices().size(), 4u);
  for (const VertexId v : star.vertices()) {
    // The middle of the square that the triangle is half of.
    const auto points = forming(v);
    const Point first = *points.begin();
    const Point last = *points.rbegin();
    const double low = std::min({first.y, last.y, std::next(points.begin())->y});
    const auto corner = std::find_if(cell.vertices.begin(), cell.vertices.end(), [&](auto& vertex) {
      return vertex.centre == Point{first.x + 0.5, low + 0.5};
    });
    ASSERT_NE(corner, cell.vertices.end());
    EXPECT_LE(forming(corner->vertex), points);
    EXPECT_EQ(forming(corner->vertex).count({2, 2}), 1u);
  }
}

TEST(PlaneCell, of_points_one_ulp_apart_has_its_area_to_every_digit) {
  const auto tessellation = tessellation_of<2>(lattice(0x1p-52, 0x1p-52, {1, 1}));
  EXPECT_EQ(cell_at<2>(tessellation, {1 + 0x1p-51, 1 + 0x1p-51}).area, 0x1p-104);
}

TEST(PlaneCell, that_is_a_needle_has_its_area_to_every_digit) {
  const double thin = 0x1p-20;
  const double wide = 0x1p20;
  // At right angles, along (3, 4) and (-4, 3), which are 5 long.
  const auto tessellation = tessellation_of<2>({{0, 0},
                                                {3 * thin, 4 * thin},
                                                {-3 * thin, -4 * thin},
                                                {-4 * wide, 3 * wide},
                                                {4 * wide, -3 * wide}});
  EXPECT_DOUBLE_EQ(cell_at<2>(tessellation, {0, 0}).area, 25);
}

TEST(PlaneCell, on_the_hull_runs_from_ray_to_ray) {
  const auto tessellation = tessellation_of<2>(lattice(1, 2, {0, 0}));
  const PlaneCell edge = cell_at<2>(tessellation, {2, 0});
  EXPECT_FALSE(edge.is_bounded);
  EXPECT_TRUE(std::isinf(edge.area));
  EXPECT_EQ(centres(edge), (std::vector<Point>{{2.5, 1}, {1.5, 1}}));
  EXPECT_EQ(neighbours(tessellation, edge), (std::vector<Point>{{3, 0}, {2, 2}, {1, 0}}));
  ASSERT_EQ(edge.rays.size(), 2u);
  EXPECT_EQ(edge.rays[0].from, 0u);
  EXPECT_EQ(edge.rays[0].direction, (Point{0, -1}));
  EXPECT_EQ(edge.rays[1].from, 1u);
  EXPECT_EQ(edge.rays[1].direction, (Point{0, -1}));

  const PlaneCell corner = cell_at<2>(tessellation, {4, 8});
  EXPECT_EQ(centres(corner), (std::vector<Point>{{3.5, 7}}));
  EXPECT_EQ(neighbours(tessellation, corner), (std::vector<Point>{{3, 8}, {4, 6}}));
  EXPECT_EQ(corner.rays[0].direction, (Point{0, 1}));
  EXPECT_EQ(corner.rays[1].direction, (Point{1, 0}));
}

TEST(PlaneCell, of_fewer_dimensions_has_neighbours_alone) {
  const auto alone = tessellation_of<2>({{1, 2}});
  EXPECT_TRUE(cell_at<2>(alone, {1, 2}).neighbours.empty());
  EXPECT_TRUE(std::isinf(cell_at<2>(alone, {1, 2}).area));
  const auto line = tessellation_of<2>({{3, 3}, {1, 1}, {7, 7}, {4, 4}});
  const PlaneCell strip = cell_at<2>(line, {4, 4});
  EXPECT_EQ(neighbours(line, strip), (std::vector<Point>{{3, 3}, {7, 7}}));
  EXPECT_TRUE(strip.vertices.empty());
  EXPECT_FALSE(strip.is_bounded);
  EXPECT_EQ(neighbours(line, cell_at<2>(line, {7, 7})), (std::vector<Point>{{4, 4}}));
}

double area_of_vertices(const PlaneCell& cell, Point p) {
  double doubled = 0;
  for (std::size_t i = 0; i < cell.vertices.size(); ++i) {
    const Point v = cell.vertices[i].centre;
    const Point w = cell.vertices[(i + 1) % cell.vertices.size()].centre;
    doubled += (v.x - p.x) * (w.y - p.y) - (v.y - p.y) * (w.x - p.x);
  }
  return doubled / 2;
}

// Of a homogeneous Poisson process: 6 sides, and the area's variance is 0.2802 of its square.
TEST(PlaneCell, of_a_random_sample_has_the_known_statistics) {
  Seeded seeded;
  const std::size_t count = 20000 * seeded.rounds(1);
  const auto points = torus<2>(seeded, count);
  Tessellation<2> tessellation;
  const auto ids = tessellation.add_all(points);
  double area = 0;
  double squares = 0;
  std::size_t sides = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const PlaneCell cell = find_cell(tessellation, ids[i]);
    ASSERT_TRUE(cell.is_bounded);
    ASSERT_EQ(cell.vertices.size(), cell.neighbours.size());
    ASSERT_NEAR(area_of_vertices(cell, points[i]), cell.area, 1e-9 * cell.area);
    area += cell.area;
    squares += cell.area * cell.area;
    sides += cell.neighbours.size();
  }
  const auto n = static_cast<double>(count);
  EXPECT_NEAR(area, 1, 1e-12);
  EXPECT_EQ(sides, 6 * count);  // Euler's relation on a torus
  // The areas' fourth moment is near that of a gamma distribution: 3 + 6 * 0.28.
  EXPECT_NEAR(squares * n - 1, 0.2802, 5 * 0.2802 * std::sqrt(3.68 / n));
}

// Whatever was added, deleted and undone before.
TEST(Cells, depend_on_the_points_alone) {
  Seeded seeded;
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i) {
    points.push_back(
        {static_cast<double>(seeded.below(20)), static_cast<double>(seeded.below(20))});
  }
  const auto first = tessellation_of<2>(points);
  std::shuffle(points.begin(), points.end(), seeded.generator());
  Tessellation<2> second;
  for (const Point p : points) second.add(p);
  first.for_each_point([&](PointId p) {
    const PlaneCell cell = find_cell(first, p);
    const PlaneCell other = cell_at<2>(second, first.position(p));
    EXPECT_EQ(centres(cell), centres(other));
    EXPECT_EQ(neighbours(first, cell), neighbours(second, other));
    EXPECT_EQ(cell.area, other.area);
  });
}

}  // namespace
}  // namespace thiessen
