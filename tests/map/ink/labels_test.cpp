#include "map/ink/labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace thiessen {
namespace {

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

double distance(const PixelBox& box, Point p) {
  return std::hypot(std::max({box.x - p.x, 0.0, p.x - box.right()}),
                    std::max({box.y - p.y, 0.0, p.y - box.bottom()}));
}

TEST(Labels, never_overlap_each_other_or_the_border_and_stand_beside_no_other_dot) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    const int width = 300 + 40 * static_cast<int>(seed);
    const int height = 400;
    std::uniform_real_distribution<double> x(0, width);
    std::uniform_real_distribution<double> y(0, height);
    std::uniform_int_distribution<int> length(5, 70);
    const int radius = 3;
    Occupancy map(width, height);
    std::vector<Point> dots;
    std::vector<PixelBox> dot_boxes;
    for (unsigned i = 0; i < 40 * seed; ++i) {
      dots.push_back({x(random), y(random)});
      dot_boxes.push_back({static_cast<int>(dots.back().x) - radius,
                           static_cast<int>(dots.back().y) - radius, 2 * radius + 1,
                           2 * radius + 1});
      map.occupy(dot_boxes.back());
    }
    const double reach = 8;
    const DotIndex index(width, height, dots, reach);
    std::vector<PixelBox> labels;
    for (const Point dot : dots) {
      const auto box = place_beside(map, index, dot, radius, 1, length(random), 11);
      if (!box) continue;
      map.occupy(*box);
      labels.push_back(*box);
      for (const Point other : dots) {
        const double least = std::max(reach, 1.5 * distance(*box, dot));
        ASSERT_TRUE(other == dot || distance(*box, other) >= least) << "seed " << seed;
      }
    }
    ASSERT_GT(labels.size(), 15u) << "seed " << seed;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const PixelBox& box = labels[i];
      ASSERT_TRUE(box.x >= 0 && box.y >= 0 && box.right() <= width && box.bottom() <= height);
      for (const PixelBox& dot : dot_boxes) ASSERT_FALSE(overlap(box, dot)) << "seed " << seed;
      for (std::size_t j = 0; j < i; ++j) ASSERT_FALSE(overlap(box, labels[j])) << "seed " << seed;
    }
  }
}

TEST(Labels, stand_right_of_a_lone_dot) {
  const Occupancy map(100, 100);
  const auto box = place_beside(map, DotIndex(100, 100, {{50, 50}}, 5), {50, 50}, 3, 1, 30, 10);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->x, 54);
  EXPECT_EQ(box->y, 45);
}

TEST(Labels, go_left_at_the_right_border_and_nowhere_in_a_full_map) {
  Occupancy map(100, 100);
  const DotIndex dots(100, 100, {{95, 50}}, 5);
  const auto box = place_beside(map, dots, {95, 50}, 3, 1, 30, 10);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->right(), 91);
  map.occupy({0, 0, 100, 100});
  EXPECT_FALSE(place_beside(map, dots, {50, 50}, 3, 1, 30, 10));
}

// The label right of the dot is 4 pixels from it, and its end as far from the other.
TEST(Labels, do_not_stand_half_way_between_two_dots) {
  const Occupancy map(200, 100);
  const auto place = [&](Point other) {
    return place_beside(map, DotIndex(200, 100, {{50, 50}, other}, 1), {50, 50}, 3, 1, 30, 10);
  };
  EXPECT_EQ(place({91, 50})->x, 54) << "7 pixels";
  EXPECT_NE(place({88, 50})->x, 54) << "4 pixels";
}

// What counts is how far the letters are, which stand 2 pixels within the label.
TEST(Labels, are_measured_by_their_letters) {
  const Occupancy map(200, 100);
  const DotIndex dots(200, 100, {{50, 50}, {91, 50}}, 1);
  EXPECT_EQ(place_beside(map, dots, {50, 50}, 3, 1, 30, 10)->x, 54) << "4 and 7 pixels";
  EXPECT_NE(place_beside(map, dots, {50, 50}, 3, 1, 30, 10, 3)->x, 54) << "7 and 10";
}

// The place right of the dot is beside the other one, 4 pixels below the label; left there is none.
TEST(Labels, do_not_stand_beside_the_dot_of_another_gauge) {
  const Occupancy map(100, 100);
  const std::vector<Point> dots{{50, 50}, {75, 59}};
  const auto box = place_beside(map, DotIndex(100, 100, dots, 5), dots[0], 3, 1, 30, 10);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->right(), 46);
  EXPECT_EQ(
      place_beside(map, DotIndex(100, 100, {{50, 50}, {75, 62}}, 3), dots[0], 3, 1, 30, 10)->x, 54);
  EXPECT_TRUE(place_beside(map, DotIndex(100, 100, {{50, 50}, {50, 50}}, 5), dots[0], 3, 1, 30, 10))
      << "two gauges at one place";
}

}  // namespace
}  // namespace thiessen
