// Which vertices round a point coincide, judged by comparing every two of them.
#include "tessellation/coinciding_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "geometry/space_predicates.h"
#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

/// The positions of a vertex's finite forming points.
std::vector<SpacePoint> points_of(const Tessellation<3>& tessellation, VertexId v) {
  std::vector<SpacePoint> points;
  for (const PointId p : tessellation.topology().forming(v)) {
    if (p != infinite_point) points.push_back(tessellation.position(p));
  }
  return points;
}

bool are_on_one_sphere(const std::vector<SpacePoint>& v, const std::vector<SpacePoint>& w) {
  return std::all_of(w.begin(), w.end(), [&](const SpacePoint& p) {
    return in_sphere(v[0], v[1], v[2], v[3], p) == 0;
  });
}

bool are_on_one_circle(const std::vector<SpacePoint>& v, const std::vector<SpacePoint>& w) {
  const Axis dropped = projection_axis(v[0], v[1], v[2]);
  return std::all_of(w.begin(), w.end(), [&](const SpacePoint& p) {
    return orientation(v[0], v[1], v[2], p) == 0 &&
           in_circle_in_plane(dropped, v[0], v[1], v[2], p) == 0;
  });
}

/// Calls `look` for points of every family that spans the space.
template <typename Look>
void for_each_star(Look&& look) {
  Seeded seeded;
  std::size_t count = 0;
  for (const FamilyIn<3>& family : families::all_in_space(seeded, 30)) {
    const Tessellation<3> tessellation = tessellation_of(family.points);
    if (tessellation.span() != Span::space) continue;
    SCOPED_TRACE(family.name);
    Star<3> star;
    tessellation.for_each_point([&](PointId p) {
      if (index(p) % 4 != 1) return;
      tessellation.find_star(p, star);
      look(tessellation, star, CoincidingVertices(tessellation, star, p));
      ++count;
    });
  }
  EXPECT_GT(count, 100u);
}

TEST(CoincidingVertices, law_1_finite_ones_do_where_their_points_are_on_one_sphere) {
  std::size_t coinciding = 0;
  for_each_star([&](const Tessellation<3>& tessellation, const Star<3>& star,
                    const CoincidingVertices& same) {
    for (const VertexId v : star.vertices()) {
      const auto of_v = points_of(tessellation, v);
      for (const VertexId w : star.vertices()) {
        const auto of_w = points_of(tessellation, w);
        if (of_v.size() != 4 || of_w.size() != 4) continue;
        ASSERT_EQ(same.coincide(v, w), are_on_one_sphere(of_v, of_w));
        coinciding += v != w && same.coincide(v, w) ? 1u : 0u;
      }
    }
  });
  EXPECT_GT(coinciding, 100u);
}

TEST(CoincidingVertices, law_2_rays_do_where_their_facets_are_on_one_circle) {
  std::size_t coinciding = 0;
  for_each_star([&](const Tessellation<3>& tessellation, const Star<3>& star,
                    const CoincidingVertices& same) {
    for (const VertexId v : star.vertices()) {
      const auto of_v = points_of(tessellation, v);
      for (const VertexId w : star.vertices()) {
        const auto of_w = points_of(tessellation, w);
        if (of_v.size() == 4) continue;
        ASSERT_EQ(same.coincide(v, w), of_w.size() == 3 && are_on_one_circle(of_v, of_w));
        coinciding += v != w && same.coincide(v, w) ? 1u : 0u;
      }
    }
  });
  EXPECT_GT(coinciding, 20u);
}

TEST(CoincidingVertices, law_3_a_group_is_named_by_the_vertex_whose_points_come_first) {
  for_each_star([&](const Tessellation<3>& tessellation, const Star<3>& star,
                    const CoincidingVertices& same) {
    std::set<std::size_t> groups;
    for (const VertexId v : star.vertices()) {
      const std::size_t group = same.group_of(v);
      groups.insert(group);
      ASSERT_LT(group, same.first().size());
      const VertexId first = same.first()[group];
      ASSERT_NE(first, no_vertex);
      ASSERT_EQ(same.group_of(first), group);
      ASSERT_LE(in_order(tessellation, first), in_order(tessellation, v));
    }
    const auto unused = std::count(same.first().begin(), same.first().end(), no_vertex);
    ASSERT_EQ(groups.size() + static_cast<std::size_t>(unused), star.vertices().size());
  });
}

TEST(CoincidingVertices, law_4_inside_of_a_ray_is_the_finite_vertex_at_its_facet) {
  for_each_star([&](const Tessellation<3>& tessellation, const Star<3>& star,
                    const CoincidingVertices& same) {
    for (const VertexId v : star.vertices()) {
      if (!tessellation.topology().is_infinite(v)) continue;
      const VertexId w = same.inside(v);
      ASSERT_FALSE(tessellation.topology().is_infinite(w));
      for (const PointId p : tessellation.topology().forming(v)) {
        ASSERT_TRUE(p == infinite_point || tessellation.topology().corner_of(w, p) < 4);
      }
    }
  });
}

// The cell of a lattice's inner point is a cube; that of its corner an octant with three edges.
TEST(CoincidingVertices, of_a_lattice_are_the_corners_of_a_cube_and_of_an_octant) {
  const Tessellation<3> lattice = tessellation_of(families::lattice_in_space(27, 1, {0, 0, 0}, 0));
  Star<3> star;
  const auto count = [&](const SpacePoint& position, bool of_rays) {
    const PointId p = *lattice.find(position);
    lattice.find_star(p, star);
    const CoincidingVertices same(lattice, star, p);
    return std::count_if(same.first().begin(), same.first().end(), [&](VertexId v) {
      return v != no_vertex && lattice.topology().is_infinite(v) == of_rays;
    });
  };
  EXPECT_EQ(count({1, 1, 1}, false), 8);
  EXPECT_EQ(count({1, 1, 1}, true), 0);
  EXPECT_EQ(count({0, 0, 0}, false), 1);
  EXPECT_EQ(count({0, 0, 0}, true), 3);
  EXPECT_EQ(count({1, 1, 0}, false), 4);
  EXPECT_EQ(count({1, 1, 0}, true), 4);
}

}  // namespace
}  // namespace thiessen
