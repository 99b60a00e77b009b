#include "geometry/box_tree.h"

#include <algorithm>
#include <numeric>

#include "geometry/hilbert.h"

namespace thiessen {

BoxTree::BoxTree(std::span<const Box> boxes) : positions_(boxes.size()) {
  if (boxes.empty()) return;
  Box all;
  for (const Box& box : boxes) all.take_in(box);
  std::vector<std::uint32_t> distance(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    distance[i] = hilbert_distance(all, boxes[i].centre());
  }
  std::iota(positions_.begin(), positions_.end(), 0u);
  std::sort(positions_.begin(), positions_.end(), [&](std::uint32_t i, std::uint32_t j) {
    return distance[i] != distance[j] ? distance[i] < distance[j] : i < j;
  });

  std::vector<Box> level;
  level.reserve(boxes.size());
  for (const std::uint32_t position : positions_) level.push_back(boxes[position]);
  levels_.push_back(std::move(level));
  while (levels_.back().size() > fan) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> groups((below.size() + fan - 1) / fan);
    for (std::size_t i = 0; i < below.size(); ++i) groups[i / fan].take_in(below[i]);
    levels_.push_back(std::move(groups));
  }
}

}  // namespace thiessen
