#include "tessellation/topology.h"

#include <gtest/gtest.h>

#include <vector>

#include "tessellation/id_table.h"
#include "tessellation/simplices.h"
#include "tessellation/space_families.h"
#include "tessellation/star.h"

namespace thiessen {
namespace {

template <typename Constant>
class TopologyOf : public InDimension<Constant> {};
TYPED_TEST_SUITE(TopologyOf, PlaneAndSpace);

template <int Dimension>
void fill(Topology<Dimension>& topology, VertexId v, std::uint32_t first) {
  auto& row = topology.fill(v);
  for (std::size_t i = 0; i <= Dimension; ++i) {
    row.forming[i] = PointId{first + static_cast<std::uint32_t>(i)};
    row.neighbours[i] = VertexId{first + static_cast<std::uint32_t>(i) + 10};
  }
}

TYPED_TEST(TopologyOf, nothing_knows_the_infinite_point_alone) {
  constexpr int d = TestFixture::dimension;
  const Topology<d> topology;
  EXPECT_EQ(topology.dimension(), -1);
  EXPECT_EQ(topology.size(), 0u);
  EXPECT_EQ(topology.count(), 0u);
  EXPECT_EQ(topology.point_limit(), 1u);
  EXPECT_FALSE(topology.is_there(infinite_point));
  EXPECT_FALSE(topology.is_there(no_point));
  topology.for_each_vertex([](VertexId) { ADD_FAILURE(); });
}

// The table of freed simplices: the last freed is used first.
TYPED_TEST(TopologyOf, freed_rows_are_used_again_first) {
  constexpr int d = TestFixture::dimension;
  Topology<d> topology;
  std::vector<VertexId> rows;
  for (int i = 0; i < 5; ++i) {
    rows.push_back(topology.allocate());
    fill(topology, rows.back(), 1);
  }
  EXPECT_EQ(rows[4], VertexId{4});
  topology.release(rows[1]);
  topology.release(rows[3]);
  EXPECT_TRUE(topology.is_free(rows[1]));
  EXPECT_TRUE(topology.is_free(rows[3]));
  EXPECT_FALSE(topology.is_free(rows[2]));
  std::vector<VertexId> used;
  topology.for_each_vertex([&](VertexId v) { used.push_back(v); });
  EXPECT_EQ(used, (std::vector<VertexId>{rows[0], rows[2], rows[4]}));
  EXPECT_EQ(topology.allocate(), rows[3]);
  EXPECT_EQ(topology.allocate(), rows[1]);
  EXPECT_EQ(topology.allocate(), VertexId{5});
  EXPECT_EQ(topology.size(), 6u);
}

TYPED_TEST(TopologyOf, freed_numbers_are_given_again_first) {
  constexpr int d = TestFixture::dimension;
  Topology<d> topology;
  std::vector<PointId> points;
  for (int i = 0; i < 4; ++i) {
    points.push_back(topology.allocate_point());
    topology.set_vertex_of(points.back(), VertexId{7});
  }
  EXPECT_EQ(points.front(), PointId{1});
  EXPECT_EQ(topology.count(), 4u);
  topology.release_point(points[0]);
  topology.release_point(points[2]);
  EXPECT_EQ(topology.count(), 2u);
  EXPECT_FALSE(topology.is_there(points[0]));
  EXPECT_TRUE(topology.is_there(points[1]));
  EXPECT_EQ(topology.vertex_of(points[1]), VertexId{7});
  EXPECT_EQ(topology.allocate_point(), points[2]);
  EXPECT_EQ(topology.allocate_point(), points[0]);
  EXPECT_EQ(topology.allocate_point(), PointId{5});
  EXPECT_EQ(topology.point_limit(), 6u);
}

TYPED_TEST(TopologyOf, a_row_knows_its_corners_and_sides) {
  constexpr int d = TestFixture::dimension;
  Topology<d> topology;
  const VertexId v = topology.allocate();
  fill(topology, v, 3);
  EXPECT_EQ(topology.corner_of(v, PointId{3}), 0u);
  EXPECT_EQ(topology.corner_of(v, PointId{3 + d}), static_cast<std::size_t>(d));
  EXPECT_EQ(topology.corner_of(v, PointId{99}), Topology<d>::corners);
  EXPECT_EQ(topology.side_towards(v, VertexId{14}), 1u);
  EXPECT_EQ(topology.neighbour(v, 1), VertexId{14});
  EXPECT_FALSE(topology.is_infinite(v));
  topology.change(v).forming[1] = infinite_point;
  EXPECT_TRUE(topology.is_infinite(v));
}

// Recorded changes taken back and made again, the rows and numbers that came with them included.
TYPED_TEST(TopologyOf, changes_are_exchanged_bit_for_bit) {
  constexpr int d = TestFixture::dimension;
  using Changes = typename Topology<d>::Changes;
  Topology<d> topology;
  for (std::uint32_t i = 0; i < 3; ++i) fill(topology, topology.allocate(), i);
  topology.set_vertex_of(topology.allocate_point(), VertexId{2});
  topology.release(VertexId{1});
  const auto bits = [&] {
    std::vector<std::uint32_t> words{topology.state().rows,
                                     topology.state().points,
                                     topology.state().points_there,
                                     topology.state().first_free_point,
                                     static_cast<std::uint32_t>(topology.state().first_free),
                                     static_cast<std::uint32_t>(topology.state().dimension)};
    for (std::uint32_t v = 0; v < topology.size(); ++v) {
      for (std::size_t i = 0; i <= d; ++i) {
        words.push_back(static_cast<std::uint32_t>(topology.forming(VertexId{v})[i]));
        words.push_back(static_cast<std::uint32_t>(topology.neighbour(VertexId{v}, i)));
      }
    }
    for (std::uint32_t p = 0; p < topology.point_limit(); ++p)
      words.push_back(static_cast<std::uint32_t>(topology.vertex_of(PointId{p})));
    return words;
  };
  const auto before = bits();
  Changes changes;
  auto state = topology.state();
  topology.record_in(&changes);
  EXPECT_EQ(topology.recorded_in(), &changes);
  topology.change(VertexId{0}).neighbours[0] = VertexId{77};
  topology.release(VertexId{2});
  fill(topology, topology.allocate(), 40);
  fill(topology, topology.allocate(), 50);
  fill(topology, topology.allocate(), 60);  // a row that was not there
  topology.change(VertexId{0}).neighbours[1] = VertexId{78};
  topology.release_point(PointId{1});
  topology.set_vertex_of(topology.allocate_point(), VertexId{0});
  topology.set_vertex_of(topology.allocate_point(), VertexId{3});
  topology.set_dimension(d);
  topology.record_in(nullptr);
  const auto after = bits();
  const auto extent = changes.extent();
  topology.change(VertexId{0}).neighbours[1] = topology.neighbour(VertexId{0}, 1);
  EXPECT_EQ(changes.rows.size(), extent.rows);  // nothing is kept any more
  for (int i = 0; i < 3; ++i) {
    topology.exchange(changes, {}, extent, state, true);
    EXPECT_EQ(bits(), before);
    topology.exchange(changes, {}, extent, state, false);
    EXPECT_EQ(bits(), after);
  }
  changes.cut({1, 0});
  EXPECT_EQ(changes.extent().rows, 1u);
  EXPECT_EQ(changes.extent().points, 0u);
}

// Neighbour i is across from forming point i (section 1.2): it has all the others.
TYPED_TEST(TopologyOf, a_tessellation_has_neighbours_in_the_order_of_the_thesis) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 60)) {
    SCOPED_TRACE(family.name);
    const Tessellation<d> tessellation = tessellation_of(family.points);
    const Topology<d>& topology = tessellation.topology();
    if (topology.dimension() < 1) continue;
    const auto corners = static_cast<std::size_t>(topology.dimension()) + 1;
    topology.for_each_vertex([&](VertexId v) {
      for (std::size_t i = 0; i < corners; ++i) {
        const VertexId w = topology.neighbour(v, i);
        for (std::size_t k = 0; k < corners; ++k) {
          const bool shared = topology.corner_of(w, topology.forming(v)[k]) < corners;
          ASSERT_EQ(shared, k != i);
        }
      }
      for (std::size_t i = corners; i < Topology<d>::corners; ++i) {
        ASSERT_EQ(topology.forming(v)[i], no_point);
        ASSERT_EQ(topology.neighbour(v, i), no_vertex);
      }
    });
  }
}

template <typename Constant>
class StarOf : public InDimension<Constant> {};
TYPED_TEST_SUITE(StarOf, PlaneAndSpace);

// Against every row of the table.
TYPED_TEST(StarOf, a_point_is_the_rows_that_have_it) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  Star<d> star;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 40)) {
    SCOPED_TRACE(family.name);
    const Tessellation<d> tessellation = tessellation_of(family.points);
    const Topology<d>& topology = tessellation.topology();
    if (topology.dimension() < 1) continue;
    for (std::uint32_t i = 0; i < topology.point_limit(); ++i) {
      const PointId p{i};
      std::vector<VertexId> rows;
      std::vector<PointId> neighbours;
      topology.for_each_vertex([&](VertexId v) {
        if (topology.corner_of(v, p) == Topology<d>::corners) return;
        rows.push_back(v);
        for (const PointId q : topology.forming(v)) {
          if (q != p && q != no_point) neighbours.push_back(q);
        }
      });
      tessellation.find_star(p, star);
      std::vector<VertexId> found = star.vertices();
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, rows);
      std::vector<PointId> points = star.points();
      std::sort(points.begin(), points.end());
      ASSERT_EQ(points, distinct(neighbours));
      if (p == infinite_point) continue;
      std::vector<PointId> visited;
      tessellation.for_each_neighbour(p, star, [&](PointId q) { visited.push_back(q); });
      std::vector<PointId> again;
      tessellation.for_each_neighbour(p, [&](PointId q) { again.push_back(q); });
      ASSERT_EQ(again, visited);
      std::sort(visited.begin(), visited.end());
      points.erase(std::remove(points.begin(), points.end(), infinite_point), points.end());
      ASSERT_EQ(visited, points);
    }
  }
}

TEST(StarInPlane, is_in_order_counter_clockwise) {
  Seeded seeded;
  const Tessellation<2> tessellation = tessellation_of(families::uniform(seeded, 200));
  Star<2> star;
  tessellation.for_each_point([&](PointId p) {
    tessellation.find_star(p, star);
    const std::size_t count = star.points().size();
    ASSERT_EQ(star.vertices().size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      const PointId a = star.points()[i];
      const PointId b = star.points()[(i + 1) % count];
      const VertexId v = star.vertices()[i];
      ASSERT_LT(tessellation.topology().corner_of(v, a), 3u);
      ASSERT_LT(tessellation.topology().corner_of(v, b), 3u);
      if (a == infinite_point || b == infinite_point) continue;
      ASSERT_EQ(
          orientation(tessellation.position(p), tessellation.position(a), tessellation.position(b)),
          1);
    }
  });
}

TEST(NeighboursInPlane, of_a_lattice_point_are_at_least_its_four_next) {
  const Tessellation<2> tessellation = tessellation_of(families::lattice(100, 1, {0, 0}, 0));
  std::vector<Point> neighbours;
  tessellation.for_each_neighbour(*tessellation.nearest({5, 5}), [&](PointId p) {
    neighbours.push_back(tessellation.position(p));
  });
  for (const Point next : {Point{4, 5}, Point{6, 5}, Point{5, 4}, Point{5, 6}}) {
    EXPECT_EQ(std::count(neighbours.begin(), neighbours.end(), next), 1);
  }
}

TEST(NeighboursInSpace, of_a_lattice_point_are_at_least_its_six_next) {
  const Tessellation<3> tessellation =
      tessellation_of(families::lattice_in_space(125, 1, {0, 0, 0}, 0));
  std::vector<SpacePoint> neighbours;
  tessellation.for_each_neighbour(*tessellation.find({2, 2, 2}), [&](PointId p) {
    neighbours.push_back(tessellation.position(p));
  });
  for (const SpacePoint& next : {SpacePoint{1, 2, 2}, SpacePoint{3, 2, 2}, SpacePoint{2, 1, 2},
                                 SpacePoint{2, 3, 2}, SpacePoint{2, 2, 1}, SpacePoint{2, 2, 3}}) {
    EXPECT_EQ(std::count(neighbours.begin(), neighbours.end(), next), 1);
  }
}

// On a line one on either side, and the ends with one.
TYPED_TEST(StarOf, a_point_of_a_line_is_two_segments) {
  constexpr int d = TestFixture::dimension;
  Tessellation<d> tessellation;
  const std::vector<PointId> ids =
      tessellation.add_all(std::vector<PositionIn<d>>{{0, 0}, {1, 1}, {2, 2}});
  const auto neighbours = [&](PointId p) {
    std::vector<PointId> found;
    tessellation.for_each_neighbour(p, [&](PointId q) { found.push_back(q); });
    std::sort(found.begin(), found.end());
    return found;
  };
  EXPECT_EQ(neighbours(ids[0]), std::vector<PointId>{ids[1]});
  EXPECT_EQ(neighbours(ids[1]), distinct(std::vector<PointId>{ids[0], ids[2]}));
  EXPECT_EQ(neighbours(ids[2]), std::vector<PointId>{ids[1]});
}

TEST(IdTable, finds_what_was_inserted_until_it_is_cleared) {
  IdTable<2> table;
  EXPECT_EQ(table.find({1, 2}), nullptr);
  const auto [value, is_new] = table.insert({1, 2}, 30);
  EXPECT_TRUE(is_new);
  EXPECT_EQ(*value, 30u);
  const auto [again, is_new_again] = table.insert({1, 2}, 40);
  EXPECT_FALSE(is_new_again);
  EXPECT_EQ(*again, 30u);
  *again = 50;
  EXPECT_EQ(*table.find({1, 2}), 50u);
  EXPECT_EQ(table.find({2, 1}), nullptr);
  EXPECT_EQ(table.size(), 1u);
  table.clear();
  EXPECT_EQ(table.size(), 0u);
  EXPECT_EQ(table.find({1, 2}), nullptr);
}

TEST(IdTable, holds_any_number_of_keys_again_and_again) {
  IdTable<1> table;
  for (int round = 0; round < 5; ++round) {
    for (std::uint32_t i = 0; i < 10000; ++i) EXPECT_TRUE(table.insert({i * 64}, i).second);
    EXPECT_EQ(table.size(), 10000u);
    for (std::uint32_t i = 0; i < 10000; ++i) ASSERT_EQ(*table.find({i * 64}), i);
    EXPECT_EQ(table.find({1}), nullptr);
    table.clear();
  }
}

}  // namespace
}  // namespace thiessen
