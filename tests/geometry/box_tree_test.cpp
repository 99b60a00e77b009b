#include "geometry/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

std::vector<std::uint32_t> found_by_tree(const BoxTree& tree, const Box& sought) {
  std::vector<std::uint32_t> found;
  tree.search(sought, [&](std::uint32_t position) { found.push_back(position); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::uint32_t> found_one_by_one(const std::vector<Box>& boxes, const Box& sought) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const Box& b = boxes[i];
    const bool apart = b.high.x < sought.low.x || sought.high.x < b.low.x ||
                       b.high.y < sought.low.y || sought.high.y < b.low.y;
    if (!apart) found.push_back(i);
  }
  return found;
}

Box random_box(Seeded& seeded, double largest) {
  const Point low{seeded.uniform(-10, 10), seeded.uniform(-10, 10)};
  return {low, {low.x + seeded.uniform(0, largest), low.y + seeded.uniform(0, largest)}};
}

TEST(BoxTree, finds_what_looking_at_each_box_finds) {
  Seeded seeded;
  for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 64u, 65u, 512u, 513u, 3000u}) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < count; ++i) boxes.push_back(random_box(seeded, 1));
    const BoxTree tree(boxes);
    for (int i = 0; i < 100; ++i) {
      const Box sought = random_box(seeded, 4);
      ASSERT_EQ(found_by_tree(tree, sought), found_one_by_one(boxes, sought)) << count;
    }
  }
}

TEST(BoxTree, takes_touching_boxes_for_meeting) {
  const std::vector<Box> boxes{{{0, 0}, {1, 1}}, {{1, 1}, {1, 1}}, {{2, 0}, {3, 0}}};
  const BoxTree tree(boxes);
  EXPECT_EQ(found_by_tree(tree, {{1, 1}, {2, 2}}), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(found_by_tree(tree, {{1, -1}, {2, 0}}), (std::vector<std::uint32_t>{0, 2}));
}

TEST(BoxTree, tells_equal_boxes_apart) {
  const std::vector<Box> boxes(100, Box{{4, 4}, {4, 4}});
  EXPECT_EQ(found_by_tree(BoxTree(boxes), {{4, 4}, {4, 4}}).size(), 100u);
}

}  // namespace
}  // namespace thiessen
