#include "geometry/direction.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

void expect_same(Direction found, Direction wanted) {
  EXPECT_EQ(found.x, wanted.x);
  EXPECT_EQ(found.y, wanted.y);
  EXPECT_EQ(found.z, wanted.z);
}

constexpr Direction a{1, 2, 3};
constexpr Direction b{4, -5, 6};

TEST(Direction, adds_and_scales_by_coordinates) {
  expect_same(a + b, {5, -3, 9});
  expect_same(a - b, {-3, 7, -3});
  expect_same(2 * a, {2, 4, 6});
}

TEST(Direction, has_a_dot_product_of_lengths_and_their_angle) {
  EXPECT_EQ(dot(a, b), 4 - 10 + 18);
  EXPECT_EQ(dot({1, 0, 0}, {0, 1, 0}), 0);
  EXPECT_EQ(length({2, -3, 6}), 7);
}

TEST(Direction, has_a_cross_product_by_the_right_hand) {
  expect_same(cross({1, 0, 0}, {0, 1, 0}), {0, 0, 1});
  expect_same(cross(a, b), {27, 6, -13});
}

TEST(Direction, keeps_its_way_when_it_becomes_a_unit) {
  expect_same(unit({0, 0, -8}), {0, 0, -1});
  EXPECT_DOUBLE_EQ(unit({2, -3, 6}).y, -3.0 / 7);
}

}  // namespace
}  // namespace thiessen
