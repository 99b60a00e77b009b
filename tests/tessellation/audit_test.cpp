#include "tessellation/audit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

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

template <int Dimension>
bool finds(const std::vector<Finding<Dimension>>& findings, Fault fault) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const auto& f) { return f.fault == fault; });
}

// That the audit finds the fault, and shows forming points of the vertices at which it is.
template <int Dimension>
void expect_found(const Structure<Dimension>& structure, Fault fault) {
  const auto findings = audit(structure);
  EXPECT_TRUE(finds(findings, fault)) << name_of(fault);
  for (const Finding<Dimension>& f : findings) {
    if (f.vertex == no_vertex || f.fault == Fault::point_without_simplex) continue;
    bool is_there = false;
    for (const PointId p : structure.topology().forming(f.vertex)) {
      if (p == infinite_point || !structure.topology().is_there(p)) continue;
      is_there = is_there || structure.position(p) == f.position;
    }
    EXPECT_TRUE(is_there) << name_of(f.fault);
  }
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

template <typename Constant>
class AuditOf : public InDimension<Constant> {};
TYPED_TEST_SUITE(AuditOf, PlaneAndSpace);

/// Sound tessellations of every span but those too small to break.
template <int Dimension>
std::vector<Tessellation<Dimension>> sound_ones() {
  Seeded seeded;
  std::vector<Tessellation<Dimension>> all;
  if constexpr (Dimension == 2) {
    all.push_back(tessellation_of(families::line(10, {0, 0}, {1, 2})));
    all.push_back(tessellation_of(families::uniform(seeded, 50)));
  } else {
    all.push_back(tessellation_of(families::line_in_space(10, {0, 0, 0}, {1, 2, 3})));
    all.push_back(
        tessellation_of(families::on_plane(families::lattice(49, 1, {0, 0}, 0), {0, 0, 0}, 2, -1)));
    all.push_back(tessellation_of(families::uniform_in_space(seeded, 50)));
  }
  return all;
}

// Of every sound tessellation: what is left of it after `damage` has the fault.
template <int Dimension, typename Damage>
void expect_found_after(Damage&& damage, Fault fault) {
  for (Tessellation<Dimension>& tessellation : sound_ones<Dimension>()) {
    SCOPED_TRACE("dimension " + std::to_string(tessellation.topology().dimension()));
    EXPECT_TRUE(audit(tessellation).empty());
    damage(tessellation.structure_to_break());
    expect_found(tessellation.structure(), fault);
  }
}

template <int Dimension>
VertexId some_finite(const Structure<Dimension>& structure) {
  return structure.finite_vertex(structure.topology().vertex_of(PointId{7}));
}

TYPED_TEST(AuditOf, broken_links_finds_them) {
  constexpr int d = TestFixture::dimension;
  expect_found_after<d>(
      [](Structure<d>& s) { s.topology().fill(some_finite(s)).neighbours[0] = no_vertex; },
      Fault::link_to_nothing);
  expect_found_after<d>(
      [](Structure<d>& s) { s.topology().fill(some_finite(s)).neighbours[1] = VertexId{1u << 20}; },
      Fault::link_to_nothing);
  expect_found_after<d>([](Structure<d>& s) { s.topology().release(some_finite(s)); },
                        Fault::link_to_nothing);
  expect_found_after<d>(
      [](Structure<d>& s) { s.topology().fill(some_finite(s)).neighbours[0] = some_finite(s); },
      Fault::facet_not_shared);
}

TYPED_TEST(AuditOf, a_link_that_is_not_returned_finds_it) {
  constexpr int d = TestFixture::dimension;
  expect_found_after<d>(
      [](Structure<d>& s) {
        const VertexId v = some_finite(s);
        const auto corners = static_cast<std::size_t>(s.topology().dimension()) + 1;
        s.topology().for_each_vertex([&](VertexId w) {
          bool apart = w != v;
          for (std::size_t i = 0; i < corners; ++i)
            apart = apart && s.topology().neighbour(w, i) != v;
          if (apart) s.topology().fill(v).neighbours[0] = w;
        });
      },
      Fault::link_not_returned);
}

TYPED_TEST(AuditOf, neighbours_turned_against_each_other_finds_them) {
  constexpr int d = TestFixture::dimension;
  expect_found_after<d>(
      [](Structure<d>& s) {
        auto& row = s.topology().fill(some_finite(s));
        std::swap(row.forming[0], row.forming[1]);
        std::swap(row.neighbours[0], row.neighbours[1]);
      },
      Fault::facet_not_shared);
  expect_found_after<d>(
      [](Structure<d>& s) {
        auto& row = s.topology().fill(some_finite(s));
        std::swap(row.neighbours[0], row.neighbours[1]);
      },
      Fault::facet_not_shared);
}

TYPED_TEST(AuditOf, wrong_forming_points_finds_them) {
  constexpr int d = TestFixture::dimension;
  expect_found_after<d>(
      [](Structure<d>& s) {
        auto& row = s.topology().fill(some_finite(s));
        row.forming[0] = row.forming[1];
      },
      Fault::repeated_forming_point);
  expect_found_after<d>(
      [](Structure<d>& s) { s.topology().fill(some_finite(s)).forming[0] = PointId{1u << 20}; },
      Fault::repeated_forming_point);
  expect_found_after<d>([](Structure<d>& s) { s.topology().release_point(PointId{7}); },
                        Fault::repeated_forming_point);
  expect_found_after<d>(
      [](Structure<d>& s) {
        const VertexId v = some_finite(s);
        std::uint32_t other = 1;
        while (s.topology().corner_of(v, PointId{other}) != Topology<d>::corners) ++other;
        s.topology().fill(v).forming[0] = PointId{other};
      },
      Fault::facet_not_shared);
}

TYPED_TEST(AuditOf, a_point_with_a_simplex_of_others_finds_it) {
  constexpr int d = TestFixture::dimension;
  expect_found_after<d>(
      [](Structure<d>& s) {
        s.topology().for_each_vertex([&](VertexId v) {
          if (s.topology().corner_of(v, PointId{7}) == Topology<d>::corners)
            s.topology().set_vertex_of(PointId{7}, v);
        });
      },
      Fault::point_without_simplex);
  expect_found_after<d>(
      [](Structure<d>& s) { s.topology().set_vertex_of(PointId{7}, VertexId{1u << 20}); },
      Fault::point_without_simplex);
}

TYPED_TEST(AuditOf, a_point_in_no_simplex_finds_it) {
  constexpr int d = TestFixture::dimension;
  expect_found_after<d>(
      [](Structure<d>& s) {
        s.topology().set_vertex_of(s.add_point({0.5, 0.5}), some_finite(s));
      },
      Fault::point_without_simplex);
  expect_found_after<d>(
      [](Structure<d>& s) {
        s.add_point({0.5, 0.5});
      },
      Fault::number_of_simplices);
}

// The freed number is given again, to another position.
template <int Dimension>
void move(Structure<Dimension>& structure, PointId p, const PositionIn<Dimension>& to) {
  const VertexId v = structure.topology().vertex_of(p);
  structure.topology().release_point(p);
  ASSERT_EQ(structure.add_point(to), p);
  structure.topology().set_vertex_of(p, v);
}

TYPED_TEST(AuditOf, a_point_moved_off_its_line_or_plane_finds_it) {
  constexpr int d = TestFixture::dimension;
  for (Tessellation<d>& tessellation : sound_ones<d>()) {
    if (tessellation.topology().dimension() == d) continue;
    // Whichever point is moved, and those that say what the line or plane is.
    for (std::uint32_t i = 1; i < tessellation.topology().point_limit(); ++i) {
      Tessellation<d> moved = tessellation;
      auto c = coordinates(moved.position(PointId{i}));
      c.back() += 0x1p-20;
      move<d>(moved.structure_to_break(), PointId{i}, position_of<d>(c));
      expect_found(moved.structure(), Fault::point_off_span);
    }
  }
}

TYPED_TEST(AuditOf, a_point_moved_past_others_finds_it) {
  constexpr int d = TestFixture::dimension;
  for (Tessellation<d>& tessellation : sound_ones<d>()) {
    const PointId p{7};
    Tessellation<d> moved = tessellation;
    auto c = coordinates(moved.position(PointId{9}));
    const auto other = coordinates(moved.position(PointId{8}));
    for (std::size_t i = 0; i < c.size(); ++i) c[i] += 3 * (c[i] - other[i]);
    move<d>(moved.structure_to_break(), p, position_of<d>(c));
    EXPECT_FALSE(audit(moved).empty());
    EXPECT_TRUE(audit_links(moved.structure()).empty());
    EXPECT_FALSE(audit_hull(moved.structure()).empty());
  }
}

// Every single damage to a link or to a forming point is found.
TYPED_TEST(AuditOf, any_one_number_changed_finds_it) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const Tessellation<d>& sound : sound_ones<d>()) {
    const auto corners = static_cast<std::uint64_t>(sound.topology().dimension()) + 1;
    for (int i = 0; i < 2000; ++i) {
      Tessellation<d> damaged = sound;
      Topology<d>& topology = damaged.structure_to_break().topology();
      const VertexId v{static_cast<std::uint32_t>(seeded.below(topology.size()))};
      if (topology.is_free(v)) continue;
      const std::size_t corner = seeded.below(corners);
      auto& row = topology.fill(v);
      const auto before = row;
      if (i % 2 == 0) {
        row.forming[corner] =
            PointId{static_cast<std::uint32_t>(seeded.below(topology.point_limit() + 1))};
      } else {
        row.neighbours[corner] =
            VertexId{static_cast<std::uint32_t>(seeded.below(topology.size() + 1))};
      }
      const bool same = before.forming == row.forming && before.neighbours == row.neighbours;
      ASSERT_EQ(audit(damaged).empty(), same);
    }
  }
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
