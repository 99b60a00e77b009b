// The mesh of triangles: closed, and closed after any flips.
#include "earth/cells/cell_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "earth/mesh_of_places.h"

namespace thiessen {
namespace {

TEST(CellMesh, law_1_is_closed_with_two_triangles_a_place_less_four) {
  Seeded seeded;
  for (const std::size_t count : {3u, 4u, 5u, 50u}) {
    std::vector<Point> places;
    while (places.size() < count) places.push_back(random_point(seeded));
    const CellMesh mesh((SphereTessellation(places)));
    EXPECT_EQ(mesh.triangles(), 2 * count - 4);
    EXPECT_EQ(mesh.sides(), 3 * mesh.triangles());
    expect_closed(mesh);
  }
}

/// The same triangle, told from one of its corners on.
std::array<PlaceIndex, 3> from_corner(std::array<PlaceIndex, 3> corners, PlaceIndex first) {
  std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), first), corners.end());
  return corners;
}

// On the equator all places lie on one circle: a fan to either side.
TEST(CellMesh, law_2_of_places_on_one_circle_is_two_fans) {
  std::vector<Point> places;
  for (int i = 0; i < 7; ++i) places.push_back({50.0 * i - 180, 0});
  const CellMesh mesh((SphereTessellation(places)));
  EXPECT_EQ(mesh.triangles(), 10u);
  expect_closed(mesh);
}

TEST(CellMesh, law_3_flips_keep_it_closed_and_join_the_two_apexes) {
  Seeded seeded;
  std::vector<Point> places;
  while (places.size() < 40) places.push_back(random_point(seeded));
  CellMesh mesh((SphereTessellation(places)));
  int flips = 0;
  for (int i = 0; i < 300; ++i) {
    const SideIndex s{static_cast<std::uint32_t>(seeded.below(mesh.sides()))};
    const PlaceIndex a = mesh.apex(s);
    const PlaceIndex d = mesh.apex(mesh.twin(s));
    const PlaceIndex b = mesh.from(s);
    const PlaceIndex c = mesh.to(s);
    if (a == d) continue;
    ++flips;
    const std::uint32_t t = CellMesh::triangle_of(s);
    const std::uint32_t w = CellMesh::triangle_of(mesh.twin(s));
    mesh.flip(s);
    EXPECT_EQ(from_corner(mesh.corners(t), a), (std::array{a, b, d}));
    EXPECT_EQ(from_corner(mesh.corners(w), a), (std::array{a, d, c}));
  }
  EXPECT_GT(flips, 100);
  expect_closed(mesh);
}

TEST(CellMesh, law_4_sides_go_round_their_triangle) {
  for (std::uint32_t t = 0; t < 5; ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const SideIndex s = CellMesh::side(t, i);
      EXPECT_EQ(CellMesh::triangle_of(s), t);
      EXPECT_EQ(CellMesh::next(s), CellMesh::side(t, (i + 1) % 3));
      EXPECT_EQ(CellMesh::previous(CellMesh::next(s)), s);
    }
  }
}

}  // namespace
}  // namespace thiessen
