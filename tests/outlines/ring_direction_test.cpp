#include "outlines/ring_direction.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace thiessen {
namespace {

const Ring square = {{1, 1}, {3, 1}, {3, 4}, {1, 4}};

TEST(SignedArea, is_positive_counter_clockwise) {
  EXPECT_EQ(signed_area(square), 6);
  Ring back = square;
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(signed_area(back), -6);
}

TEST(SignedArea, of_what_has_no_area_is_0) {
  EXPECT_EQ(signed_area({}), 0);
  EXPECT_EQ(signed_area({{1, 2}}), 0);
  EXPECT_EQ(signed_area({{1, 2}, {3, 5}}), 0);
  EXPECT_EQ(signed_area({{0, 0}, {4, 0}, {2, 0}}), 0);
  EXPECT_EQ(signed_area({{0, 0}, {2, 2}, {0, 2}, {2, 0}}), 0) << "a bow tie";
}

TEST(SignedArea, law_1_does_not_depend_on_the_first_point_nor_on_a_repeated_last_one) {
  Ring ring = {{0, 0}, {5, 1}, {4, 6}, {2, 3}, {-1, 4}};
  // Green by hand: the sum of x y' - x' y over the edges is 0 + 26 + 0 + 11 + 0.
  for (std::size_t i = 0; i < ring.size(); ++i) {
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    EXPECT_EQ(signed_area(ring), 37 / 2.0);
    Ring closed = ring;
    closed.push_back(ring.front());
    EXPECT_EQ(signed_area(closed), 37 / 2.0);
  }
}

// A square metre at UTM offsets: the products of the coordinates are 3e12.
TEST(SignedArea, law_2_far_from_the_origin_is_that_of_the_same_ring_near_it) {
  Ring far = square;
  for (Point& point : far) point = {point.x + 500000, point.y + 5500000};
  EXPECT_EQ(signed_area(far), 6);
}

TEST(TurnRings, makes_outer_rings_counter_clockwise_and_holes_clockwise_from_their_first_points) {
  const Ring clockwise = {{1, 1}, {1, 4}, {3, 4}, {3, 1}};
  const Ring hole = {{2, 2}, {2.5, 2}, {2, 3}};
  MultiPolygon shape = {{clockwise, {hole}}, {square, {}}};
  turn_rings(shape);
  EXPECT_EQ(shape[0].outer, square);
  EXPECT_EQ(shape[0].holes[0], (Ring{{2, 2}, {2, 3}, {2.5, 2}}));
  EXPECT_EQ(shape[1].outer, square);
  MultiPolygon again = shape;
  turn_rings(again);
  EXPECT_EQ(again[0].outer, shape[0].outer);
  EXPECT_EQ(again[0].holes, shape[0].holes);
}

TEST(TurnRings, leaves_alone_what_has_no_direction) {
  MultiPolygon shape = {{{}, {{{1, 1}}, {{1, 1}, {2, 2}}}}};
  turn_rings(shape);
  EXPECT_TRUE(shape[0].outer.empty());
  EXPECT_EQ(shape[0].holes[1], (Ring{{1, 1}, {2, 2}}));
}

}  // namespace
}  // namespace thiessen
