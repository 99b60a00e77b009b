#include "geometry/box_tree.h"

#include <algorithm>

#include "geometry/hilbert.h"

namespace thiessen {

BoxTree::BoxTree(std::span<const Box> boxes) : positions_(boxes.size()) {
  if (boxes.empty()) return;
  Box all;
  for (const Box& box : boxes) all.take_in(box);
  constexpr int position_bits = 32;
  std::vector<std::uint64_t> order(boxes.size());  // along the curve, then by position
  for (std::size_t i = 0; i < boxes.size(); ++i)
    order[i] = std::uint64_t{hilbert_distance(all, boxes[i].centre())} << position_bits | i;
  std::sort(order.begin(), order.end());
  std::ranges::transform(order, positions_.begin(),
                         [](std::uint64_t entry) { return static_cast<std::uint32_t>(entry); });
  order = {};

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
