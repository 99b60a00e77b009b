#include "diagram/plane_centres.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

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

}  // namespace
}  // namespace thiessen
