#include "map/ink/labels.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace thiessen {
namespace {

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

TEST(Labels, never_overlap_each_other_or_a_dot_or_the_border) {
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
    std::vector<PixelBox> labels;
    for (const Point dot : dots) {
      const auto box = place_beside(map, dot, radius, 1, length(random), 11);
      if (!box) continue;
      map.occupy(*box);
      labels.push_back(*box);
    }
    ASSERT_GT(labels.size(), 20u) << "seed " << seed;
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
  const auto box = place_beside(map, {50, 50}, 3, 1, 30, 10);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->x, 54);
  EXPECT_EQ(box->y, 45);
}

TEST(Labels, go_left_at_the_right_border_and_nowhere_in_a_full_map) {
  Occupancy map(100, 100);
  const auto box = place_beside(map, {95, 50}, 3, 1, 30, 10);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->right(), 91);
  map.occupy({0, 0, 100, 100});
  EXPECT_FALSE(place_beside(map, {50, 50}, 3, 1, 30, 10));
}

}  // namespace
}  // namespace thiessen
