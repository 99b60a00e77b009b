// The tessellation against CGAL's Delaunay triangulation of the same points.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "tessellation/audit.h"
#include "tessellation/families.h"
#include "tessellation/structure.h"

namespace thiessen {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;
using Edge = std::array<Point, 2>;

Point point_of(const Kernel::Point_2& p) {
  return {p.x(), p.y()};
}

Edge edge_of(Point a, Point b) {
  return a < b ? Edge{a, b} : Edge{b, a};
}

/// CGAL's edges but those that a tie decides: four points on one circle.
std::set<Edge> certain_edges(const Triangulation& triangulation) {
  std::set<Edge> edges;
  for (auto e = triangulation.finite_edges_begin(); e != triangulation.finite_edges_end(); ++e) {
    const auto face = e->first;
    const int i = e->second;
    const auto other = face->neighbor(i);
    const bool on_hull = triangulation.is_infinite(face) || triangulation.is_infinite(other);
    const auto across = triangulation.mirror_vertex(face, i);
    const bool tie = !on_hull && triangulation.side_of_oriented_circle(face, across->point()) ==
                                     CGAL::ON_ORIENTED_BOUNDARY;
    if (tie) continue;
    edges.insert(edge_of(point_of(face->vertex(face->cw(i))->point()),
                         point_of(face->vertex(face->ccw(i))->point())));
  }
  return edges;
}

std::set<Edge> edges_of(const Tessellation& tessellation) {
  std::set<Edge> edges;
  for (const PlainSimplex& s : plain_simplices(tessellation)) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = s.at(i);
      const Point b = s.at((i + 1) % 3);
      if (std::isfinite(a.x) && std::isfinite(b.x)) edges.insert(edge_of(a, b));
    }
  }
  return edges;
}

void expect_same_as_cgal(std::span<const Point> points) {
  std::vector<Kernel::Point_2> theirs;
  for (const Point p : points) theirs.emplace_back(p.x, p.y);
  const Triangulation triangulation(theirs.begin(), theirs.end());
  Tessellation tessellation;
  tessellation.add_all(points);

  ASSERT_EQ(static_cast<int>(tessellation.span()) - 1, triangulation.dimension());
  ASSERT_TRUE(audit(tessellation).empty());
  if (tessellation.span() != Span::plane) {
    ASSERT_EQ(tessellation.along_line().size(), triangulation.number_of_vertices());
    return;
  }
  const std::set<Edge> ours = edges_of(tessellation);
  const std::set<Edge> certain = certain_edges(triangulation);
  EXPECT_TRUE(std::includes(ours.begin(), ours.end(), certain.begin(), certain.end()));
  std::size_t finite = 0;
  for (const PlainSimplex& s : plain_simplices(tessellation))
    finite += std::isfinite(s[1].x) && std::isfinite(s[2].x);
  EXPECT_EQ(finite, triangulation.number_of_faces());
}

TEST(DelaunayAgainstCgal, every_family) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5); ++round) {
    for (const std::size_t count : {5u, 20u, 150u, 2000u}) {
      for (const Family& family : families::all(seeded, count)) {
        SCOPED_TRACE(family.name);
        expect_same_as_cgal(family.points);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST(DelaunayAgainstCgal, thousands_of_small_degenerate_sets) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5000); ++round) {
    const std::size_t count = 3 + seeded.below(12);
    std::vector<Point> points = families::small_grid(seeded, count, 1 + seeded.whole(0, 3));
    if (round % 3 == 1) points = families::ulp_cluster(seeded, count, {0.1, 4e6}, 2);
    if (round % 3 == 2) {
      points = families::whole_circle({0, 0});
      std::shuffle(points.begin(), points.end(), seeded.generator());
      points.resize(count);
    }
    expect_same_as_cgal(points);
    if (testing::Test::HasFailure()) return;
  }
}

// Points that broke other programs, from their public trackers and papers.
TEST(DelaunayAgainstCgal, shapely_issue_972_a_rectangle) {
  expect_same_as_cgal(std::vector<Point>{
      {20.1273, 18.7303}, {26.5107, 18.7303}, {20.1273, 23.8437}, {26.5107, 23.8437}});
}

TEST(DelaunayAgainstCgal, geos_issue_1062_a_cell_became_a_line) {
  expect_same_as_cgal(std::vector<Point>{{-819831.1, -1007946.473},
                                         {-819831.1, -1007945.994},
                                         {-819829.184, -1007947.9099999999},
                                         {-819829.663, -1007947.9099999999}});
}

TEST(DelaunayAgainstCgal, delaunay_triangulation_issue_32_almost_on_a_line) {
  expect_same_as_cgal(std::vector<Point>{{0, 0}, {1000, 0}, {2000, 40}});
}

// Kettner and others, Classroom examples of robustness problems, 2008.
TEST(DelaunayAgainstCgal, kettners_failure_a1) {
  expect_same_as_cgal(std::vector<Point>{{7.3000000000000194, 7.3000000000000167},
                                         {24.000000000000068, 24.000000000000071},
                                         {24.00000000000005, 24.000000000000053},
                                         {0.50000000000001621, 0.50000000000001243},
                                         {8, 4},
                                         {4, 9},
                                         {15, 27},
                                         {26, 25},
                                         {19, 11}});
}

TEST(DelaunayAgainstCgal, kettners_grid_of_ulps_and_far_corners) {
  std::vector<Point> points{{12, 12}, {24, 24}, {-12, 30}, {30, -12}};
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) points.push_back({0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53});
  }
  expect_same_as_cgal(points);
}

}  // namespace
}  // namespace thiessen
