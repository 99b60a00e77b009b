// The steps of an insertion (section 2.2) by themselves: what comes, what goes and what stays.
#include "tessellation/insertion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

template <typename Constant>
class InsertionIn : public InDimension<Constant> {};
TYPED_TEST_SUITE(InsertionIn, PlaneAndSpace);

/// One insertion: the tessellation before it, what the point is in conflict with, and what came.
template <int Dimension>
struct Inserted {
  const Tessellation<Dimension>& before;
  const ConflictZone<Dimension>& zone;
  const Tessellation<Dimension>& after;
  PointId point;
  VertexId vertex;

  const Topology<Dimension>& old_topology() const { return before.topology(); }
  const Topology<Dimension>& topology() const { return after.topology(); }
  bool was_deleted(VertexId v) const {
    return std::count(zone.vertices().begin(), zone.vertices().end(), v) == 1;
  }
};

/// Inserts a quarter of the points of every family into the tessellation of the others, each alone,
/// and calls `look`. All insertions are made by one object.
template <int Dimension, typename Look>
void for_each_insertion(Look&& look) {
  Seeded seeded;
  Insertion<Dimension> insertion;
  std::size_t count = 0;
  for (const FamilyIn<Dimension>& family : families::all_in<Dimension>(seeded, 40)) {
    SCOPED_TRACE(family.name);
    std::vector<PositionIn<Dimension>> points = distinct(family.points);
    std::shuffle(points.begin(), points.end(), seeded.generator());
    const std::size_t kept = points.size() - points.size() / 4;
    const std::vector<PositionIn<Dimension>> others(
        points.begin(), points.begin() + static_cast<std::ptrdiff_t>(kept));
    const Tessellation<Dimension> before = tessellation_of(others);
    ConflictZone<Dimension> zone;
    for (std::size_t i = kept; i < points.size(); ++i) {
      if (before.span() < Span::line || before.structure().is_off(points[i])) continue;
      ASSERT_TRUE(before.find_conflict_zone(points[i], {}, zone));
      Tessellation<Dimension> after = before;
      Structure<Dimension>& structure = after.structure_to_break();
      const PointId q = structure.add_point(points[i]);
      const VertexId v = insertion.insert(structure, q, before.locate(points[i]));
      look(Inserted<Dimension>{before, zone, after, q, v});
      if (testing::Test::HasFatalFailure()) return;
      ++count;
    }
  }
  EXPECT_GT(count, 100u);
}

TYPED_TEST(InsertionIn, law_1_it_gives_the_tessellation_of_all_points) {
  constexpr int d = TestFixture::dimension;
  for_each_insertion<d>([](const Inserted<d>& inserted) {
    std::vector<PositionIn<d>> points = positions_of(inserted.before);
    points.push_back(inserted.after.position(inserted.point));
    ASSERT_EQ(plain_simplices(inserted.after), plain_simplices(tessellation_of(points)));
    expect_sound(inserted.after);
  });
}

// One for each facet of the rim, and no others: the vertices that come are those of the new point.
TYPED_TEST(InsertionIn, law_2_the_new_vertices_are_those_that_the_point_forms) {
  constexpr int d = TestFixture::dimension;
  for_each_insertion<d>([](const Inserted<d>& inserted) {
    const Topology<d>& topology = inserted.topology();
    std::size_t formed = 0;
    topology.for_each_vertex([&](VertexId v) {
      if (topology.corner_of(v, inserted.point) == Topology<d>::corners) return;
      ++formed;
      const bool is_new = index(v) >= inserted.old_topology().size() ||
                          inserted.old_topology().is_free(v) || inserted.was_deleted(v);
      ASSERT_TRUE(is_new);
    });
    ASSERT_EQ(formed, inserted.zone.rim().size());
    ASSERT_LT(topology.corner_of(inserted.vertex, inserted.point), Topology<d>::corners);
    ASSERT_EQ(topology.vertex_of(inserted.point), inserted.vertex);
  });
}

TYPED_TEST(InsertionIn, law_3_a_vertex_outside_the_zone_keeps_its_points_and_all_but_its_rim) {
  constexpr int d = TestFixture::dimension;
  for_each_insertion<d>([](const Inserted<d>& inserted) {
    inserted.old_topology().for_each_vertex([&](VertexId v) {
      if (inserted.was_deleted(v)) return;
      ASSERT_EQ(inserted.topology().forming(v), inserted.old_topology().forming(v));
      for (std::size_t side = 0; side < Topology<d>::corners; ++side) {
        const VertexId w = inserted.old_topology().neighbour(v, side);
        const bool is_rim = w != no_vertex && inserted.was_deleted(w);
        if (!is_rim) {
          ASSERT_EQ(inserted.topology().neighbour(v, side), w);
        }
      }
    });
  });
}

// A line grows by one segment and a plane by two triangles, those with the infinite point included.
TYPED_TEST(InsertionIn, law_4_the_rows_of_the_deleted_are_used_again_or_free) {
  constexpr int d = TestFixture::dimension;
  for_each_insertion<d>([](const Inserted<d>& inserted) {
    const int spanned = inserted.topology().dimension();
    const std::size_t came = inserted.zone.rim().size();
    const std::size_t went = inserted.zone.vertices().size();
    if (spanned < 3) {
      ASSERT_EQ(came, went + static_cast<std::size_t>(spanned));
    }
    for (const VertexId v : inserted.zone.vertices()) {
      const bool is_of_point =
          inserted.topology().corner_of(v, inserted.point) != Topology<d>::corners;
      ASSERT_TRUE(is_of_point || (spanned != 2 && inserted.topology().is_free(v)));
    }
    std::size_t used = 0;
    inserted.topology().for_each_vertex([&](VertexId) { ++used; });
    ASSERT_EQ(used, plain_simplices(inserted.before).size() + came - went);
  });
}

// In a triangle a point makes three of it. Beyond one of its sides it makes another one there, and
// two sides of the hull take the place of one.
TEST(InsertionInPlane, of_a_point_in_a_triangle_and_of_one_beyond_a_side) {
  const Tessellation<2> triangle = tessellation_of<2>({{0, 0}, {8, 0}, {0, 8}});
  for (const auto& [q, finite] : {std::pair{Point{2, 2}, 3u}, std::pair{Point{9, 9}, 2u}}) {
    Tessellation<2> changed = triangle;
    Structure<2>& structure = changed.structure_to_break();
    Insertion<2> insertion;
    insertion.insert(structure, structure.add_point(q), triangle.locate(q));
    EXPECT_EQ(count_finite(changed), finite);
    EXPECT_EQ(plain_simplices(changed).size() - finite, finite == 3 ? 3u : 4u);
    expect_sound(changed);
  }
}

}  // namespace
}  // namespace thiessen
