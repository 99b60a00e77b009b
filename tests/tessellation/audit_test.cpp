#include "tessellation/audit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace thiessen {
namespace {

using Forming = Topology<2>::Forming;

constexpr PointId p0{0}, p1{1}, p2{2}, p3{3};

// Links every two simplices that have an edge in common.
Topology<2> linked(const std::vector<Forming>& simplices) {
  Topology<2> topology;
  for (const Forming& forming : simplices) topology.allocate(forming);
  for (std::uint32_t v = 0; v < topology.size(); ++v) {
    for (std::uint32_t w = 0; w < topology.size(); ++w) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          const Forming& a = topology.forming(VertexId{v});
          const Forming& b = topology.forming(VertexId{w});
          if (a.at((i + 1) % 3) == b.at((j + 2) % 3) && a.at((i + 2) % 3) == b.at((j + 1) % 3))
            topology.link(VertexId{v}, i, VertexId{w}, j);
        }
      }
    }
  }
  return topology;
}

// A quadrilateral 0, 1, 2, 3 with the diagonal 0-2.
const std::vector<Forming> quadrilateral{{p0, p1, p2},
                                         {p0, p2, p3},
                                         {infinite_point, p1, p0},
                                         {infinite_point, p2, p1},
                                         {infinite_point, p3, p2},
                                         {infinite_point, p0, p3}};

const std::vector<Point> kite{{0, 0}, {2, -1}, {3, 0}, {2, 1}};  // its short diagonal is 1-3
const std::vector<Point> upright_kite{{0, 0}, {2, -3}, {3, 0}, {2, 3}};
const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

bool finds(const std::vector<Finding>& findings, Fault fault) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const Finding& f) { return f.fault == fault; });
}

TEST(Audit, finds_nothing_in_a_sound_quadrilateral) {
  const Topology<2> topology = linked(quadrilateral);
  EXPECT_TRUE(audit_links(topology, upright_kite).empty());
  EXPECT_TRUE(audit_plane(topology, upright_kite).empty());
  EXPECT_TRUE(audit_circles(topology, upright_kite).empty());
}

TEST(Audit, finds_a_point_in_a_circle) {
  const Topology<2> topology = linked(quadrilateral);
  EXPECT_TRUE(audit_plane(topology, kite).empty());
  const std::vector<Finding> findings = audit_circles(topology, kite);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].fault, Fault::point_in_circle);
  EXPECT_EQ(findings[0].vertex, VertexId{0});
  EXPECT_EQ(findings[1].vertex, VertexId{1});
}

// Of a square's diagonals the one that misses (1, 1) is right.
TEST(Audit, finds_a_tie_broken_otherwise) {
  const Topology<2> topology = linked(quadrilateral);
  const std::vector<Finding> findings = audit_circles(topology, square);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].fault, Fault::tie_broken_otherwise);
}

TEST(Audit, finds_clockwise_and_flat_simplices) {
  const Topology<2> topology = linked(quadrilateral);
  const std::vector<Point> inside_out{{0, 0}, {2, 3}, {3, 0}, {2, -3}};
  EXPECT_TRUE(finds(audit_plane(topology, inside_out), Fault::simplex_not_left_turning));
  const std::vector<Point> flat{{0, 0}, {2, 0}, {3, 0}, {2, 3}};
  EXPECT_TRUE(finds(audit_plane(topology, flat), Fault::simplex_not_left_turning));
}

TEST(Audit, finds_a_hull_that_is_not_convex) {
  const std::vector<Point> dart{{0, 0}, {4, -1}, {1, 0}, {4, 1}};
  EXPECT_TRUE(finds(audit_plane(linked(quadrilateral), dart), Fault::hull_not_convex));
}

TEST(Audit, finds_a_hull_that_winds_again) {
  // Five points of a pentagram about a sixth: every simplex turns left, and so does the hull, twice
  // round.
  std::vector<Point> star{{0, 0}};
  for (const Point p : {Point{10, 0}, Point{-8, 6}, Point{3, -10}, Point{3, 10}, Point{-8, -6}})
    star.push_back(p);
  std::vector<Forming> simplices;
  for (std::uint32_t i = 0; i < 5; ++i) {
    const PointId from{1 + i};
    const PointId to{1 + (i + 1) % 5};
    simplices.push_back({p0, from, to});
    simplices.push_back({infinite_point, to, from});
  }
  const Topology<2> topology = linked(simplices);
  ASSERT_TRUE(audit_links(topology, star).empty());
  const std::vector<Finding> findings = audit_plane(topology, star);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].fault, Fault::hull_winds_again);
}

TEST(Audit, finds_links_that_are_not_returned) {
  Topology<2> topology = linked(quadrilateral);
  topology.set_neighbour(VertexId{0}, 0, VertexId{4});
  EXPECT_TRUE(finds(audit_links(topology, kite), Fault::link_not_returned));
}

TEST(Audit, finds_links_to_nothing) {
  Topology<2> topology = linked(quadrilateral);
  topology.set_neighbour(VertexId{0}, 0, no_vertex);
  EXPECT_TRUE(finds(audit_links(topology, kite), Fault::link_to_nothing));
  Topology<2> freed = linked(quadrilateral);
  freed.release(VertexId{5});
  EXPECT_TRUE(finds(audit_links(freed, kite), Fault::link_to_nothing));
}

TEST(Audit, finds_neighbours_without_a_common_edge) {
  Topology<2> topology = linked(quadrilateral);
  topology.link(VertexId{2}, 0, VertexId{4}, 0);
  EXPECT_TRUE(finds(audit_links(topology, kite), Fault::edge_not_shared));
}

TEST(Audit, finds_repeated_forming_points) {
  Topology<2> topology = linked(quadrilateral);
  const VertexId v = topology.allocate({p1, p1, p2});
  for (std::size_t i = 0; i < 3; ++i) topology.set_neighbour(v, i, VertexId{0});
  EXPECT_TRUE(finds(audit_links(topology, kite), Fault::repeated_forming_point));
}

TEST(Audit, finds_a_surface_in_two_pieces) {
  std::vector<Forming> twice = quadrilateral;
  const std::vector<Forming> apart{{PointId{4}, PointId{5}, PointId{6}},
                                   {PointId{7}, PointId{6}, PointId{5}},
                                   {PointId{7}, PointId{5}, PointId{4}},
                                   {PointId{7}, PointId{4}, PointId{6}}};
  twice.insert(twice.end(), apart.begin(), apart.end());
  const std::vector<Point> positions(8);
  EXPECT_TRUE(finds(audit_links(linked(twice), positions), Fault::surface_not_a_sphere));
}

TEST(Audit, names_every_fault) {
  for (int fault = 0; fault <= static_cast<int>(Fault::point_off_line); ++fault) {
    EXPECT_FALSE(name_of(static_cast<Fault>(fault)).empty());
  }
}

}  // namespace
}  // namespace thiessen
