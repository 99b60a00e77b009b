#include "geometry/voronoi_measures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace thiessen {
namespace {

TEST(Circumradius, of_a_right_triangle_is_half_its_hypotenuse) {
  EXPECT_EQ(circumradius(Point{0, 0}, {3, 0}, {0, 4}), 2.5);
  EXPECT_EQ(circumradius(Point{0, 4}, {0, 0}, {3, 0}), 2.5);
  // One ulp wide, far from the origin: half of 2^-52 times the square root of 2.
  EXPECT_DOUBLE_EQ(circumradius(Point{1, 1}, {1 + 0x1p-52, 1}, {1, 1 + 0x1p-52}),
                   0x1p-53 * std::sqrt(2.0));
}

TEST(Circumradius, of_a_box_is_half_its_diagonal) {
  EXPECT_EQ(circumradius(SpacePoint{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 6}), 3.5);
  EXPECT_EQ(circumradius(SpacePoint{0, 0, 6}, {0, 3, 0}, {2, 0, 0}, {0, 0, 0}), 3.5);
}

TEST(SectorArea, is_the_triangle_of_a_point_and_an_edge) {
  // The centres of 0, q, r and q, 0, s are (1, 1.5) and (1, -1).
  EXPECT_DOUBLE_EQ(sector_area({0, 0}, {2, 0}, {0, 3}, {0, -2}), 1.25);
  // On one circle the edge has no length.
  EXPECT_EQ(sector_area({0, 0}, {1, 1}, {0, 1}, {1, 0}), 0);
}

TEST(SectorArea, keeps_its_digits_where_centres_are_next_to_each_other) {
  // A square with a corner moved by one ulp: the centres are 2^-53 apart along the diagonal's
  // normal, but for terms of the order of 2^-104; pq is the square root of 2 long.
  const double moved = 1 + 0x1p-52;
  // The centre of 0, (1, 1), (0, moved) is at ((2 - moved) / 2, moved / 2), that of (1, 1), 0,
  // (1, 0) at (1, 1) / 2: (2^-53, 2^-53) apart.
  EXPECT_DOUBLE_EQ(sector_area({0, 0}, {1, 1}, {0, moved}, {1, 0}), 0x1p-54);
}

TEST(EdgeRatio, is_the_sum_of_cotangents) {
  // As above: 2.5 long over half of 2.
  EXPECT_DOUBLE_EQ(edge_ratio({0, 0}, {2, 0}, {0, 3}, {0, -2}), 2.5);
  // Both on the left: the centres are (1, 1.5) and (1, 3).
  EXPECT_DOUBLE_EQ(edge_ratio({0, 0}, {2, 0}, {0, 3}, {0, 6}), -1.5);
  EXPECT_EQ(edge_ratio({0, 0}, {1, 1}, {0, 1}, {1, 0}), 0);
}

TEST(SquareDifference, keeps_its_digits) {
  EXPECT_EQ(square_difference({0, 0}, {3, 4}, {6, 8}), 75);
  EXPECT_EQ(square_difference({1, 1}, {2, 2}, {2, 0}), 0);
  // (1 + u)^2 - 1 with u = 2^-52, where 1 is seen from afar.
  EXPECT_DOUBLE_EQ(square_difference({0, 0x1p40}, {1, 0}, {1 + 0x1p-52, 0}), 0x1p-51);
}

TEST(VoronoiEdge, runs_from_centre_to_centre) {
  // The spheres through 0, (2, 0, 0), (0, 2, 0) and (0, 0, -2), (0, 0, 4) have their centres at
  // (1, 1, -1) and (1, 1, 2).
  const auto edge = voronoi_edge({0, 0, 0}, {2, 0, 0}, {0, 0, -2}, {0, 2, 0}, {0, 0, 4});
  EXPECT_DOUBLE_EQ(edge.x, 0);
  EXPECT_DOUBLE_EQ(edge.y, 0);
  EXPECT_DOUBLE_EQ(edge.z, 3);
}

TEST(UnitNormal, points_to_where_the_triangle_turns_left) {
  const auto normal = unit_normal({1, 0, 5}, {2, 0, 5}, {1, 1, 5});
  EXPECT_EQ(normal.x, 0);
  EXPECT_EQ(normal.y, 0);
  EXPECT_EQ(normal.z, 1);
}

}  // namespace
}  // namespace thiessen
