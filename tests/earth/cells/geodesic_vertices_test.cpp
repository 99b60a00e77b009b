// The ellipsoid's Voronoi vertices: judged by Karney's distances, and by symmetry.
#include "earth/cells/geodesic_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "earth/mesh_of_places.h"
#include "earth/sphere/conformal_sphere.h"

namespace thiessen {
namespace {

constexpr double accuracy = 1e-6;  // metres
constexpr Box world{{-180, -90}, {180, 90}};

struct Vertices {
  explicit Vertices(std::vector<Point> its_places, const Box& frame = world, unsigned threads = 1)
      : places(std::move(its_places)), of(sphere, places, frame, accuracy, threads) {}
  std::vector<Point> places;
  SphereTessellation sphere{places};
  GeodesicVertices of;
};

struct Where {
  Point centre;
  double metres;
};

class GeodesicVerticesOf : public testing::TestWithParam<Where> {
 protected:
  Seeded seeded_;
  Vertices vertices_{places_round(seeded_, GetParam().centre, GetParam().metres, 100)};
};

TEST_P(GeodesicVerticesOf,
       law_1_an_exact_vertex_is_as_far_from_its_corners_and_no_place_is_nearer) {
  std::size_t exact = 0;
  for (std::uint32_t t = 0; t < vertices_.of.mesh().triangles(); ++t) {
    if (!vertices_.of.is_exact(t)) continue;
    const Point vertex = vertices_.of.position(t);
    const auto corners = vertices_.of.mesh().corners(t);
    const double radius = geodesic_distance(vertices_.places[index(corners[0])], vertex);
    if (radius > 5e6) continue;  // the far side has tests of its own, and is less exact
    ++exact;
    for (const PlaceIndex corner : corners)
      EXPECT_NEAR(geodesic_distance(vertices_.places[index(corner)], vertex), radius, accuracy);
    EXPECT_GE(nearest_distance(vertices_.places, vertex), radius - accuracy);
  }
  EXPECT_GT(exact, 100u);
}

TEST_P(GeodesicVerticesOf, law_2_flipping_leaves_the_mesh_closed_with_all_its_places) {
  expect_closed(vertices_.of.mesh());
  std::set<PlaceIndex> corners;
  for (std::uint32_t t = 0; t < vertices_.of.mesh().triangles(); ++t) {
    for (const PlaceIndex p : vertices_.of.mesh().corners(t)) corners.insert(p);
  }
  EXPECT_EQ(corners.size(), vertices_.places.size());
  // Euler: of a closed mesh on the sphere.
  EXPECT_EQ(vertices_.of.mesh().triangles(), 2 * vertices_.places.size() - 4);
}

TEST_P(GeodesicVerticesOf, law_3_every_side_of_the_mesh_is_told_as_neighbours) {
  std::set<std::pair<PlaceIndex, PlaceIndex>> told;
  vertices_.of.for_each_neighbours(
      [&](PlaceIndex a, PlaceIndex b) { told.insert(std::minmax(a, b)); });
  const CellMesh& mesh = vertices_.of.mesh();
  for (std::uint32_t i = 0; i < mesh.sides(); ++i) {
    const SideIndex s{i};
    EXPECT_TRUE(told.contains(std::minmax(mesh.from(s), mesh.to(s))));
  }
}

TEST_P(GeodesicVerticesOf, law_4_an_edge_runs_from_vertex_to_vertex_forward) {
  const CellMesh& mesh = vertices_.of.mesh();
  for (std::uint32_t i = 0; i < mesh.sides(); i += 7) {
    const SideIndex s{i};
    const std::uint32_t start = CellMesh::triangle_of(mesh.twin(s));
    const std::uint32_t end = CellMesh::triangle_of(s);
    if (!vertices_.of.is_exact(start) || !vertices_.of.is_exact(end)) continue;
    const GeodesicBisector edge = vertices_.of.edge(mesh.from(s), mesh.to(s));
    const auto [from, to] = vertices_.of.angles(edge, start, end);
    EXPECT_LE(from, to);
    const Point vertex = vertices_.of.position(vertices_.of.group_of(start));
    if (geodesic_distance(vertices_.places[index(mesh.from(s))], vertex) > 5e6) continue;
    EXPECT_LT(geodesic_distance(edge.find(from).position, vertex), 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Everywhere, GeodesicVerticesOf,
                         testing::Values(Where{{10, 0}, 50'000}, Where{{10, 45}, 1'000'000},
                                         Where{{180, -17}, 300'000}, Where{{0, 90}, 500'000},
                                         Where{{30, -90}, 2'000'000}));

TEST(GeodesicVertices, law_5_far_from_the_frame_they_are_left_as_on_the_sphere) {
  Seeded seeded;
  std::vector<Point> places;
  for (int i = 0; i < 200; ++i) places.push_back(random_point(seeded));
  const Vertices vertices(places, Box{{-20, 10}, {60, 70}});
  std::size_t far = 0;
  for (std::uint32_t t = 0; t < vertices.of.mesh().triangles(); ++t) {
    if (vertices.of.is_near(t)) continue;
    ++far;
    EXPECT_FALSE(vertices.of.is_exact(t));
    const auto [a, b, c] = vertices.sphere.in_order(vertices.of.mesh().corners(t));
    const Point expected = from_sphere(vertices.sphere.centre(a, b, c));
    EXPECT_LT(geodesic_distance(vertices.of.position(t), expected), 1e-7);
  }
  EXPECT_GT(far, 200u);
  EXPECT_LT(far, vertices.of.mesh().triangles());
}

TEST(GeodesicVertices, law_6_they_do_not_depend_on_threads) {
  Seeded seeded;
  const auto places = places_round(seeded, {20, 60}, 400'000, 1000);
  const Vertices one(places, world, 1);
  const Vertices three(places, world, 3);
  ASSERT_EQ(one.of.mesh().triangles(), three.of.mesh().triangles());
  for (std::uint32_t t = 0; t < one.of.mesh().triangles(); ++t) {
    EXPECT_EQ(one.of.position(t), three.of.position(t));
    EXPECT_EQ(one.of.mesh().corners(t), three.of.mesh().corners(t));
    EXPECT_EQ(one.of.group_of(t), three.of.group_of(t));
  }
}

// Three places at one latitude, a third of a turn apart.
TEST(GeodesicVertices, of_three_places_round_a_pole_are_the_poles) {
  const Vertices vertices({{-120, 70}, {0, 70}, {120, 70}});
  ASSERT_EQ(vertices.of.mesh().triangles(), 2u);
  std::vector<double> latitudes{vertices.of.position(0u).y, vertices.of.position(1u).y};
  std::sort(latitudes.begin(), latitudes.end());
  EXPECT_NEAR(latitudes[0], -90, 1e-9);
  EXPECT_NEAR(latitudes[1], 90, 1e-9);
}

// Four places on a rectangle that a meridian halves, and the equator.
TEST(GeodesicVertices, of_four_places_as_far_from_a_point_are_one_vertex_there) {
  const Vertices vertices({{9, -1}, {11, -1}, {9, 1}, {11, 1}});
  const GeodesicVertices& of = vertices.of;
  std::vector<std::uint32_t> near;
  for (std::uint32_t t = 0; t < of.mesh().triangles(); ++t) {
    if (geodesic_distance(of.position(t), {10, 0}) < 1e6) near.push_back(t);
  }
  ASSERT_EQ(near.size(), 2u);
  EXPECT_EQ(of.group_of(near[0]), of.group_of(near[1]));
  for (const std::uint32_t t : near)
    EXPECT_LT(geodesic_distance(of.position(t), {10, 0}), accuracy);
}

// An isosceles triangle across a meridian, and its mirror image across the equator.
TEST(GeodesicVertices, of_mirrored_places_are_mirrored) {
  const auto vertex_of = [](double sign) {
    const Vertices vertices({{8, sign * 50}, {12, sign * 50}, {10, sign * 53}});
    for (std::uint32_t t = 0; t < vertices.of.mesh().triangles(); ++t) {
      if (sign * vertices.of.position(t).y > 0) return vertices.of.position(t);
    }
    return Point{};
  };
  EXPECT_NEAR(vertex_of(1).x, 10, 1e-11);
  EXPECT_NEAR(vertex_of(-1).x, 10, 1e-11);
  EXPECT_NEAR(vertex_of(1).y, -vertex_of(-1).y, 1e-11);
}

}  // namespace
}  // namespace thiessen
