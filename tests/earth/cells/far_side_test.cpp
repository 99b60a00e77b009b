// The cells of the outermost places of a town, round its antipode: judged by Karney's distances.
#include "earth/cells/far_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "earth/mesh_of_places.h"

namespace thiessen {
namespace {

constexpr double accuracy = 1e-4;  // metres

/// A network, its mesh on the sphere, and the triangles whose centres are near its antipode.
struct Town {
  explicit Town(std::vector<Point> its_places) : places(std::move(its_places)) {
    for (std::uint32_t t = 0; t < mesh.triangles(); ++t) {
      if (dot(direction(t), sphere.direction(mesh.corners(t)[0])) <= -std::cos(0.06))
        far.push_back(t);
    }
  }
  Direction direction(std::uint32_t t) const {
    const auto [a, b, c] = sphere.in_order(mesh.corners(t));
    return sphere.centre(a, b, c);
  }
  std::vector<FarSide::Vertex> lay_anew(const std::vector<std::uint32_t>& triangles) {
    return FarSide(sphere, places, accuracy, mesh).lay_anew(triangles, [this](std::uint32_t t) {
      return direction(t);
    });
  }

  std::vector<Point> places;
  SphereTessellation sphere{places};
  CellMesh mesh{sphere};
  std::vector<std::uint32_t> far;
};

class FarSideOfATown : public testing::TestWithParam<Point> {
 protected:
  Seeded seeded_;
  Town town_{places_round(seeded_, GetParam(), 10'000, 12)};
};

TEST_P(FarSideOfATown, law_1_each_triangle_gets_a_vertex_as_far_from_its_three_corners) {
  ASSERT_FALSE(town_.far.empty());
  const auto vertices = town_.lay_anew(town_.far);
  std::vector<std::uint32_t> laid;
  for (const auto& [triangle, at] : vertices) {
    laid.push_back(triangle);
    for (const PlaceIndex corner : town_.mesh.corners(triangle))
      EXPECT_NEAR(geodesic_distance(town_.places[index(corner)], at.position), at.radius, 1e-3);
  }
  std::sort(laid.begin(), laid.end());
  EXPECT_EQ(laid, town_.far);
}

TEST_P(FarSideOfATown, law_2_no_place_is_nearer_to_a_vertex_than_its_corners) {
  const auto vertices = town_.lay_anew(town_.far);
  ASSERT_FALSE(vertices.empty());
  for (const auto& vertex : vertices)
    EXPECT_GE(nearest_distance(town_.places, vertex.at.position), vertex.at.radius - 2e-3);
}

TEST_P(FarSideOfATown, law_3_vertices_lie_round_the_antipode) {
  const Point centre = GetParam();
  const Point antipode{centre.x - 180, -centre.y};
  for (const auto& vertex : town_.lay_anew(town_.far))
    EXPECT_LT(geodesic_distance(antipode, vertex.at.position), 200'000);
}

TEST_P(FarSideOfATown, law_4_the_mesh_stays_closed_and_keeps_its_outermost_places) {
  const auto corners_of = [&] {
    std::set<PlaceIndex> corners;
    for (const std::uint32_t t : town_.far) {
      for (const PlaceIndex p : town_.mesh.corners(t)) corners.insert(p);
    }
    return corners;
  };
  expect_closed(town_.mesh);
  const auto before = corners_of();
  ASSERT_FALSE(town_.lay_anew(town_.far).empty());
  expect_closed(town_.mesh);
  EXPECT_EQ(corners_of(), before);
}

TEST_P(FarSideOfATown, law_5_what_is_not_one_piece_with_an_edge_is_refused_and_nothing_changed) {
  const auto sides_of = [&] {
    std::vector<SideIndex> twins;
    for (std::uint32_t s = 0; s < town_.mesh.sides(); ++s)
      twins.push_back(town_.mesh.twin(SideIndex{s}));
    return twins;
  };
  const auto before = sides_of();
  std::vector<std::uint32_t> all(town_.mesh.triangles());
  std::iota(all.begin(), all.end(), 0u);
  EXPECT_TRUE(town_.lay_anew(all).empty());  // the whole Earth has no edge
  EXPECT_TRUE(town_.lay_anew({}).empty());
  EXPECT_EQ(sides_of(), before);
}

INSTANTIATE_TEST_SUITE_P(Everywhere, FarSideOfATown,
                         testing::Values(Point{10, 0}, Point{10, 45}, Point{-120, -33},
                                         Point{179.99, 20}, Point{0, 89.9}));

}  // namespace
}  // namespace thiessen
