#include "diagram/plane_centres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "tessellation/families.h"

namespace thiessen {
namespace {

std::size_t groups_of(const std::vector<Point>& points) {
  Tessellation<2> tessellation;
  tessellation.add_all(points);
  PlaneCentres centres(tessellation);
  std::set<std::uint32_t> groups;
  tessellation.topology().for_each_vertex([&](VertexId v) {
    if (!tessellation.topology().is_infinite(v)) groups.insert(centres.group_of(v));
  });
  return groups.size();
}

TEST(PlaneCentres, cocircular_simplices_have_one) {
  EXPECT_EQ(groups_of({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), 1U);
  EXPECT_EQ(groups_of({{0, 0}, {2, 0}, {2, 2}, {0, 2.5}}), 2U);
}

TEST(PlaneCentres, have_one_where_rounding_cannot_tell_two_apart) {
  EXPECT_EQ(groups_of({{0.1, 0.1}, {0.3, 0.1}, {0.1 + 0.2, 0.3}, {0.1, 0.1 + 0.2}}), 1U);
}

TEST(PlaneCentres, tell_where_a_triangle_has_its_own) {
  Tessellation<2> tessellation;
  tessellation.add_all(std::vector<Point>{{0, 0}, {4, 0}, {0, 3}});
  const PlaneCentres centres(tessellation);
  tessellation.topology().for_each_vertex([&](VertexId v) {
    if (tessellation.topology().is_infinite(v)) return;
    EXPECT_EQ(centres.of(v), (Point{2, 1.5}));
  });
}

// Bit for bit, and with the same groups.
TEST(PlaneCentres, law_1_those_of_needed_corners_are_as_if_all_were_needed) {
  Seeded seeded;
  for (const Family& family : families::all(seeded, 400)) {
    SCOPED_TRACE(family.name);
    Tessellation<2> tessellation;
    tessellation.add_all(family.points);
    if (tessellation.span() != Span::plane) continue;
    const Topology<2>& topology = tessellation.topology();
    PlaneCentres all(tessellation);
    for (int round = 0; round < 8; ++round) {
      std::vector<bool> is_needed(topology.point_limit());
      const Point about = family.points[seeded.below(family.points.size())];
      const Point reach = family.points[seeded.below(family.points.size())];
      tessellation.for_each_point([&](PointId p) {
        const Point at = tessellation.position(p);
        is_needed[index(p)] = std::abs(at.x - about.x) <= std::abs(reach.x - about.x) / 2 &&
                              std::abs(at.y - about.y) <= std::abs(reach.y - about.y) / 2;
      });
      PlaneCentres needed(tessellation, is_needed);
      std::map<std::uint32_t, std::uint32_t> other;
      std::map<std::uint32_t, std::uint32_t> back;
      topology.for_each_vertex([&](VertexId v) {
        if (topology.is_infinite(v)) return;
        int corners = 0;
        for (const PointId p : topology.forming(v)) corners += is_needed[index(p)] ? 1 : 0;
        if (corners < 2) return;
        ASSERT_EQ(needed.of(v), all.of(v));
        const std::uint32_t group = needed.group_of(v);
        const std::uint32_t as_of_all = all.group_of(v);
        ASSERT_EQ(other.emplace(group, as_of_all).first->second, as_of_all);
        ASSERT_EQ(back.emplace(as_of_all, group).first->second, group);
      });
    }
  }
}

}  // namespace
}  // namespace thiessen
