#include "tessellation/topology.h"

#include <gtest/gtest.h>

#include <vector>

#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

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

}  // namespace
}  // namespace thiessen
