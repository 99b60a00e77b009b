// What the audit finds in sound tessellations that were damaged; audit_test.cpp has tables made up.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tessellation/audit.h"
#include "tessellation/found_faults.h"
#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

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

}  // namespace
}  // namespace thiessen
