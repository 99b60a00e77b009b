#include "tessellation/star.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

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

}  // namespace
}  // namespace thiessen
