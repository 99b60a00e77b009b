#include "tessellation/voronoi_vertex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/seeded.h"
#include "tessellation/simplices.h"

namespace thiessen {
namespace {

/// The vertices of a tessellation that lie between its points.
template <int Dimension>
std::vector<VoronoiVertex<Dimension>> vertices_of(
    const std::vector<PositionIn<Dimension>>& points) {
  const auto tessellation = tessellation_of<Dimension>(points);
  std::vector<VoronoiVertex<Dimension>> found;
  tessellation.topology().for_each_vertex([&](VertexId v) {
    if (!tessellation.topology().is_infinite(v))
      found.push_back(voronoi_vertex(tessellation.structure(), v));
  });
  return found;
}

TEST(VoronoiVertex, is_the_centre_of_the_circle_through_its_points) {
  const auto found = vertices_of<2>({{0, 0}, {6, 0}, {0, 8}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].centre, (Point{3, 4}));
  EXPECT_EQ(found[0].radius, 5);
}

// As far from (0, 0, 0) as from the others: 1 + 4 + 4 = 9.
TEST(VoronoiVertex, is_the_centre_of_the_sphere_through_its_points) {
  const auto found = vertices_of<3>({{0, 0, 0}, {2, 0, 0}, {0, 4, 0}, {0, 0, 4}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].centre, (SpacePoint{1, 2, 2}));
  EXPECT_EQ(found[0].radius, 3);
}

// Of (0, 0), (2, 0) and (1, h) it lies (1 - h^2) / 2h below, and is (1 + h^2) / 2h away.
TEST(VoronoiVertex, of_a_flat_triangle_is_far_away_and_has_every_digit) {
  const auto found = vertices_of<2>({{0, 0}, {2, 0}, {1, 0x1p-40}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].centre, (Point{1, -0x1p39}));
  EXPECT_EQ(found[0].radius, 0x1p39);
}

TEST(VoronoiVertex, law_1_does_not_depend_on_the_order_of_its_points_bit_for_bit) {
  Seeded seeded;
  const auto coordinate = [&] { return seeded.uniform(-1, 1); };
  for (std::uint64_t round = 0; round < Seeded::rounds(50); ++round) {
    std::vector<Point> corners;
    for (int i = 0; i < 3; ++i) corners.push_back({coordinate(), coordinate()});
    std::sort(corners.begin(), corners.end());
    const auto first = vertices_of<2>(corners).at(0);
    while (std::next_permutation(corners.begin(), corners.end())) {
      const auto other = vertices_of<2>(corners).at(0);
      ASSERT_EQ(other.centre, first.centre);
      ASSERT_EQ(other.radius, first.radius);
    }
    std::vector<SpacePoint> points;
    for (int i = 0; i < 4; ++i) points.push_back({coordinate(), coordinate(), coordinate()});
    std::sort(points.begin(), points.end());
    const auto in_space = vertices_of<3>(points).at(0);
    while (std::next_permutation(points.begin(), points.end())) {
      const auto other = vertices_of<3>(points).at(0);
      ASSERT_EQ(other.centre, in_space.centre);
      ASSERT_EQ(other.radius, in_space.radius);
    }
  }
}

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}
double distance(const SpacePoint& a, const SpacePoint& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// Requires each vertex to be as far from its points as its radius says, and no point to be nearer.
template <int Dimension>
void expect_empty(const std::vector<PositionIn<Dimension>>& points) {
  for (const auto& vertex : vertices_of<Dimension>(points)) {
    const double size = 1 + vertex.radius;  // points are within 1 of the origin
    std::size_t forming = 0;
    for (const auto& p : points) {
      const double from_centre = distance(vertex.centre, p);
      ASSERT_GE(from_centre, vertex.radius - 1e-12 * size);
      forming += from_centre <= vertex.radius + 1e-12 * size ? 1 : 0;
    }
    ASSERT_GE(forming, std::size_t{Dimension} + 1);
  }
}

TEST(VoronoiVertex, law_2_has_its_points_at_its_radius_and_none_nearer) {
  Seeded seeded;
  const auto coordinate = [&] { return seeded.uniform(-0.5, 0.5); };
  std::vector<Point> plane;
  std::vector<SpacePoint> space;
  for (int i = 0; i < 100; ++i) {
    plane.push_back({coordinate(), coordinate()});
    space.push_back({coordinate(), coordinate(), coordinate()});
  }
  expect_empty<2>(plane);
  expect_empty<3>(space);
}

}  // namespace
}  // namespace thiessen
