// The pieces between lines, and their unions.
#include "outlines/ring_faces.h"

#include <gtest/gtest.h>

#include "basin/shapes.h"
#include "geometry/seeded.h"
#include "outlines/polygon_validity.h"

namespace thiessen {
namespace {

MultiPolygon union_of(const std::vector<RingFace>& faces) {
  std::vector<const RingFace*> all;
  for (const RingFace& face : faces) all.push_back(&face);
  return united(all);
}

double area_of_faces(const std::vector<RingFace>& faces) {
  double sum = 0;
  for (const RingFace& face : faces) sum += face.area;
  return sum;
}

TEST(RingFaces, two_squares_that_overlap_make_three_pieces) {
  const std::vector<Ring> rings = {shapes::rectangle({0, 0}, {4, 4}),
                                   shapes::rectangle({2, 0}, {6, 4})};
  const std::vector<RingFace> faces = faces_of(rings, 0);
  ASSERT_EQ(faces.size(), 3U);
  for (const RingFace& face : faces) EXPECT_EQ(face.area, 8);
  const MultiPolygon whole = union_of(faces);
  EXPECT_EQ(whole.size(), 1U);
  EXPECT_EQ(plane_area(whole), 24);
}

TEST(RingFaces, a_ring_within_a_ring_makes_two_pieces) {
  const std::vector<Ring> rings = {shapes::rectangle({0, 0}, {4, 4}),
                                   shapes::rectangle({1, 1}, {2, 2})};
  const std::vector<RingFace> faces = faces_of(rings, 0);
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(area_of_faces(faces), 16);
  EXPECT_EQ(faces[0].shape.holes.size() + faces[1].shape.holes.size(), 1U);
}

TEST(RingFaces, on_a_grid_what_is_narrower_falls_together) {
  const std::vector<Ring> needle = {{{0, 0}, {4, 0}, {4, 4}, {8, 8}, {4, 4.001}, {0, 4}}};
  const std::vector<RingFace> faces = faces_of(needle, 0.01);
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_EQ(faces[0].area, 16);
  EXPECT_TRUE(faces_of(std::vector<Ring>{{{0, 0}, {4, 0}, {4, 0.001}}}, 0.01).empty());
}

TEST(RingFaces, law_1_any_union_of_pieces_is_valid_and_has_their_area) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(100); ++round) {
    std::vector<Ring> rings(2);
    for (Ring& ring : rings) {
      for (int i = 0; i < 8; ++i)
        ring.push_back({static_cast<double>(seeded.whole(0, 9)), seeded.uniform(0, 9)});
    }
    const double grid = seeded.below(2) == 0 ? 0 : 0.01;
    const std::vector<RingFace> faces = faces_of(rings, grid);
    std::vector<const RingFace*> some;
    double area = 0;
    for (const RingFace& face : faces) {
      if (seeded.below(2) == 0) continue;
      some.push_back(&face);
      area += face.area;
    }
    const MultiPolygon shape = united(some);
    EXPECT_EQ(validity_fault(shape), "");
    EXPECT_NEAR(plane_area(shape), area, 1e-9);
  }
}

}  // namespace
}  // namespace thiessen
