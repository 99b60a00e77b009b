#include "map/plot/box_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace thiessen {
namespace {

using Space = CoordinatesIn<3>;
constexpr Space half = {2, 1, 3};

/// Twice the area of a polygon that lies in a plane z = constant, by its vertices.
double doubled_area(const std::vector<Space>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Space& p = polygon[i];
    const Space& q = polygon[(i + 1) % polygon.size()];
    sum += p[0] * q[1] - q[0] * p[1];
  }
  return sum;
}

TEST(BoxCut, a_line_enters_and_leaves_where_its_coordinates_reach_the_sides) {
  const auto along_x = cut_to_box<3>({{-10, 0.5, 0}, {4, 0, 0}}, {}, half);
  ASSERT_TRUE(along_x);
  EXPECT_EQ(along_x->from, 2);
  EXPECT_EQ(along_x->to, 3);
  const auto diagonal = cut_to_box<2>({{0, 0}, {-1, -1}}, {}, {2, 1});
  ASSERT_TRUE(diagonal);
  EXPECT_EQ(diagonal->from, -1);
  EXPECT_EQ(diagonal->to, 1);
}

TEST(BoxCut, a_stretch_is_never_lengthened) {
  const auto cut = cut_to_box<2>({{0, 0}, {1, 0}}, {0.5, 100}, {2, 1});
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->from, 0.5);
  EXPECT_EQ(cut->to, 2);
  EXPECT_FALSE((cut_to_box<2>({{0, 0}, {1, 0}}, {3, 100}, {2, 1})));
}

TEST(BoxCut, a_line_beside_the_box_has_no_part_in_it_and_one_along_a_side_has) {
  EXPECT_FALSE((cut_to_box<3>({{0, 1.5, 0}, {1, 0, 0}}, {}, half)));
  EXPECT_FALSE((cut_to_box<2>({{0, 5}, {1, -1}}, {}, {2, 1}))) << "it passes a corner";
  const auto side = cut_to_box<3>({{0, 1, 0}, {1, 0, 0}}, {}, half);
  ASSERT_TRUE(side);
  EXPECT_EQ(side->to, 2);
  EXPECT_TRUE((cut_to_box<2>({{0, 3}, {1, -1}}, {}, {2, 1}))) << "it touches a corner";
}

TEST(BoxCut, law_1_what_is_left_of_a_line_lies_in_the_box_and_what_is_cut_off_does_not) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-4, 4);
  for (int round = 0; round < 5000; ++round) {
    const auto vector = [&] { return Space{anywhere(random), anywhere(random), anywhere(random)}; };
    const Line<3> line = {vector(), vector()};
    const auto cut = cut_to_box(line, {}, half);
    for (double t = -5; t <= 5; t += 0.37) {
      const bool inside = is_in_box<3>(line.at(t), half);
      const bool kept = cut && t >= cut->from && t <= cut->to;
      ASSERT_EQ(inside, kept) << t;
    }
  }
}

TEST(BoxCut, a_polygon_within_the_box_is_as_it_was_and_one_beside_it_is_gone) {
  const std::vector<Space> inside = {{-1, -1, 3}, {1, -1, 0}, {0, 1, -3}};
  EXPECT_EQ(cut_to_box(inside, half), inside);
  EXPECT_TRUE(cut_to_box({{3, 0, 0}, {4, 0, 0}, {3, 1, 0}}, half).empty());
  EXPECT_TRUE(cut_to_box({}, half).empty());
}

TEST(BoxCut, a_polygon_that_holds_a_side_is_cut_to_it) {
  const std::vector<Space> cut = cut_to_box({{-9, -9, 1}, {9, -9, 1}, {9, 9, 1}, {-9, 9, 1}}, half);
  EXPECT_EQ(cut.size(), 4U);
  EXPECT_EQ(doubled_area(cut), 2 * 4 * 2.0);
}

// A diamond |x| + |y| <= 2.5 in a box of half sides 2 and 1: its area 12.5 less two triangles of
// height 0.5 and two of 1.5, whose bases are twice as long.
TEST(BoxCut, corners_are_cut_off) {
  const std::vector<Space> cut =
      cut_to_box({{2.5, 0, 0}, {0, 2.5, 0}, {-2.5, 0, 0}, {0, -2.5, 0}}, half);
  EXPECT_EQ(cut.size(), 8U);
  EXPECT_NEAR(doubled_area(cut) / 2, 12.5 - 2 * 0.25 - 2 * 2.25, 1e-12);
  for (const Space& vertex : cut) EXPECT_TRUE(is_in_box<3>(vertex, half));
}

}  // namespace
}  // namespace thiessen
