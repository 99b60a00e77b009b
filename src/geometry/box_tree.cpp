#include "geometry/box_tree.h"

#include <algorithm>
#include <memory>

#include "geometry/hilbert.h"
#include "geometry/rank_order.h"

namespace thiessen {

BoxTree::BoxTree(std::span<const Box> boxes) : positions_(boxes.size()) {
  if (boxes.empty()) return;
  Box all;
  for (const Box& box : boxes) all.take_in(box);
  put_in_order(boxes, all);

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

// Along the curve, then by position.
void BoxTree::put_in_order(std::span<const Box> boxes, const Box& all) {
  const HilbertGrid<2> curve(coordinates(all.low), coordinates(all.high));
  const auto entries = std::make_unique_for_overwrite<RankedIndex[]>(boxes.size());
  const auto spare = std::make_unique_for_overwrite<RankedIndex[]>(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    entries[i] = RankedIndex{curve.distance(boxes[i].centre())} << ranked_index_bits | i;
  const std::span<const RankedIndex> order = sorted_by_rank(
      {entries.get(), boxes.size()}, {spare.get(), boxes.size()}, HilbertGrid<2>::distance_bits);
  std::ranges::transform(order, positions_.begin(), index_of);
}

}  // namespace thiessen
