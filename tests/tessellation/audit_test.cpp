#include "tessellation/audit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tessellation/found_faults.h"
#include "tessellation/simplices.h"

namespace thiessen {
namespace {

constexpr PointId p1{1}, p2{2}, p3{3}, p4{4}, p5{5}, p6{6};

template <int Dimension>
using FormingOf = typename Topology<Dimension>::Forming;

template <int Dimension>
bool has_facet(const FormingOf<Dimension>& simplex, const FormingOf<Dimension>& of,
               std::size_t across) {
  for (std::size_t i = 0; i <= Dimension; ++i) {
    if (i != across && std::count(simplex.begin(), simplex.end(), of[i]) == 0) return false;
  }
  return true;
}

// The simplices, and for every facet that only one of them has, one with the infinite point.
template <int Dimension>
std::vector<FormingOf<Dimension>> closed(std::vector<FormingOf<Dimension>> simplices) {
  const std::size_t finite = simplices.size();
  for (std::size_t v = 0; v < finite; ++v) {
    for (std::size_t i = 0; i <= Dimension; ++i) {
      std::size_t sharing = 0;
      for (std::size_t w = 0; w < finite; ++w)
        sharing += has_facet<Dimension>(simplices[w], simplices[v], i) ? 1u : 0u;
      if (sharing > 1) continue;
      FormingOf<Dimension> outside = simplices[v];
      outside[i] = infinite_point;
      std::swap(outside[(i + 1) % (Dimension + 1)], outside[(i + 2) % (Dimension + 1)]);
      simplices.push_back(outside);
    }
  }
  return simplices;
}

// Points 1, 2, ... at the positions, and simplices, linked where they have a facet in common.
template <int Dimension>
Structure<Dimension> linked(const std::vector<PositionIn<Dimension>>& positions,
                            const std::vector<FormingOf<Dimension>>& simplices) {
  Structure<Dimension> structure;
  Topology<Dimension>& topology = structure.topology();
  for (const auto& position : positions) structure.add_point(position);
  for (const auto& forming : simplices) {
    const VertexId v = topology.allocate();
    topology.fill(v).forming = forming;
    for (const PointId p : forming) topology.set_vertex_of(p, v);
  }
  for (std::size_t v = 0; v < simplices.size(); ++v) {
    for (std::size_t i = 0; i <= Dimension; ++i) {
      for (std::size_t w = 0; w < simplices.size(); ++w) {
        if (v == w || !has_facet<Dimension>(simplices[w], simplices[v], i)) continue;
        topology.fill(VertexId{static_cast<std::uint32_t>(v)}).neighbours[i] =
            VertexId{static_cast<std::uint32_t>(w)};
      }
    }
  }
  topology.set_dimension(Dimension);
  return structure;
}

const std::vector<Point> kite{{0, 0}, {2, -1}, {3, 0}, {2, 1}};  // its short diagonal is 2-4
const std::vector<Point> upright_kite{{0, 0}, {2, -3}, {3, 0}, {2, 3}};
const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

// A quadrilateral 1, 2, 3, 4 with the diagonal 1-3.
Structure<2> quadrilateral(const std::vector<Point>& positions) {
  return linked<2>(positions, {{p1, p2, p3},
                               {p1, p3, p4},
                               {infinite_point, p2, p1},
                               {infinite_point, p3, p2},
                               {infinite_point, p4, p3},
                               {infinite_point, p1, p4}});
}

// A triangle 1, 2, 3 on a circle of radius 5, and a point h over its centre and one under it.
std::vector<SpacePoint> bipyramid(double h) {
  return {{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, h}, {0, 0, -h}};
}

// Divided by the triangle, or along the axis.
Structure<3> two_simplices(const std::vector<SpacePoint>& positions) {
  return linked<3>(positions, closed<3>({{p1, p2, p3, p4}, {p1, p3, p2, p5}}));
}
Structure<3> three_simplices(const std::vector<SpacePoint>& positions) {
  return linked<3>(positions, closed<3>({{p1, p2, p5, p4}, {p2, p3, p5, p4}, {p3, p1, p5, p4}}));
}

TEST(AuditInPlane, finds_nothing_in_a_sound_quadrilateral) {
  const Structure<2> structure = quadrilateral(upright_kite);
  EXPECT_TRUE(audit_links(structure).empty());
  EXPECT_TRUE(audit_hull(structure).empty());
  EXPECT_TRUE(audit_spheres(structure).empty());
  EXPECT_TRUE(audit(structure).empty());
}

TEST(AuditInSpace, finds_nothing_in_a_sound_bipyramid) {
  for (const Structure<3>& structure :
       {two_simplices(bipyramid(10)), three_simplices(bipyramid(2))}) {
    EXPECT_TRUE(audit_links(structure).empty());
    EXPECT_TRUE(audit_hull(structure).empty());
    EXPECT_TRUE(audit_spheres(structure).empty());
    EXPECT_TRUE(audit(structure).empty());
  }
}

TEST(AuditInPlane, finds_a_point_in_a_circle) {
  const Structure<2> structure = quadrilateral(kite);
  EXPECT_TRUE(audit_hull(structure).empty());
  const std::vector<Finding<2>> findings = audit_spheres(structure);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].fault, Fault::point_in_sphere);
  EXPECT_EQ(findings[0].vertex, VertexId{0});
  EXPECT_EQ(findings[1].vertex, VertexId{1});
  expect_found(structure, Fault::point_in_sphere);
}

TEST(AuditInSpace, finds_a_point_in_a_sphere) {
  expect_found(two_simplices(bipyramid(2)), Fault::point_in_sphere);
  expect_found(three_simplices(bipyramid(10)), Fault::point_in_sphere);
  EXPECT_EQ(audit(two_simplices(bipyramid(2))).size(), 2u);
}

// Of a square's diagonals the one that misses (1, 1) is right.
TEST(AuditInPlane, finds_a_tie_broken_otherwise) {
  const std::vector<Finding<2>> findings = audit_spheres(quadrilateral(square));
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].fault, Fault::tie_broken_otherwise);
}

// (5, 0, 0) is the last in lexicographic order, so the four others make a simplex.
TEST(AuditInSpace, finds_a_tie_broken_otherwise) {
  EXPECT_TRUE(audit(three_simplices(bipyramid(5))).empty());
  const std::vector<Finding<3>> findings = audit(two_simplices(bipyramid(5)));
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].fault, Fault::tie_broken_otherwise);
}

TEST(AuditInPlane, finds_clockwise_and_flat_simplices) {
  expect_found(quadrilateral({{0, 0}, {2, 3}, {3, 0}, {2, -3}}), Fault::simplex_turned_over);
  expect_found(quadrilateral({{0, 0}, {2, 0}, {3, 0}, {2, 3}}), Fault::simplex_turned_over);
}

TEST(AuditInSpace, finds_turned_over_and_flat_simplices) {
  expect_found(two_simplices(bipyramid(-10)), Fault::simplex_turned_over);
  expect_found(two_simplices(bipyramid(0)), Fault::simplex_turned_over);
}

TEST(AuditInPlane, finds_a_hull_that_is_not_convex) {
  expect_found(quadrilateral({{0, 0}, {4, -1}, {1, 0}, {4, 1}}), Fault::hull_not_convex);
}

TEST(AuditInSpace, finds_a_hull_that_is_not_convex) {
  std::vector<SpacePoint> positions = bipyramid(10);
  positions[3].x = positions[4].x = 20;
  expect_found(two_simplices(positions), Fault::hull_not_convex);
}

// Five points of a pentagram about a sixth: every simplex turns left, and so does the hull, twice
// round.
TEST(AuditInPlane, finds_a_hull_that_winds_again) {
  const std::vector<Point> star{{10, 0}, {-8, 6}, {3, -10}, {3, 10}, {-8, -6}, {0, 0}};
  std::vector<FormingOf<2>> simplices;
  for (std::uint32_t i = 0; i < 5; ++i) {
    const PointId from{1 + i};
    const PointId to{1 + (i + 1) % 5};
    simplices.push_back({p6, from, to});
    simplices.push_back({infinite_point, to, from});
  }
  const Structure<2> structure = linked<2>(star, simplices);
  ASSERT_TRUE(audit_links(structure).empty());
  const std::vector<Finding<2>> findings = audit(structure);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].fault, Fault::hull_winds_again);
}

TEST(AuditInPlane, finds_a_surface_in_two_pieces) {
  std::vector<FormingOf<2>> simplices = closed<2>({{p1, p2, p3}});
  const PointId p7{7};
  for (const FormingOf<2>& apart :
       {FormingOf<2>{p4, p5, p6}, {p7, p6, p5}, {p7, p5, p4}, {p7, p4, p6}})
    simplices.push_back(apart);
  expect_found(linked<2>(std::vector<Point>(7), simplices), Fault::in_pieces);
}

TEST(AuditInSpace, finds_a_surface_in_two_pieces) {
  std::vector<FormingOf<3>> simplices = closed<3>({{p1, p2, p3, p4}});
  const std::vector<FormingOf<3>> apart = closed<3>({{p5, p6, PointId{7}, PointId{8}}});
  for (FormingOf<3> forming : apart) {
    std::replace(forming.begin(), forming.end(), infinite_point, PointId{9});
    simplices.push_back(forming);
  }
  expect_found(linked<3>(std::vector<SpacePoint>(9), simplices), Fault::in_pieces);
}

TEST(Audit, names_every_fault_differently) {
  std::vector<std::string_view> names;
  for (int fault = 0; fault <= static_cast<int>(Fault::tie_broken_otherwise); ++fault) {
    names.push_back(name_of(static_cast<Fault>(fault)));
    EXPECT_FALSE(names.back().empty());
  }
  EXPECT_EQ(names.size(), 14u);
  EXPECT_EQ(distinct(names).size(), names.size());
}

}  // namespace
}  // namespace thiessen
