#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "rainfall/methods/weight_sums.h"

namespace thiessen {

/// Points with the same gauges, and where the sums of these gauges' weights stand.
struct PointBlock {
  std::uint32_t first_point;
  std::uint32_t end_point;
  std::uint32_t first_sum;
  std::uint32_t end_sum;
};

/// The points of a basin, block by block, and what gauges weigh in each.
struct PointBlocks {
  std::vector<PointBlock> all;
  std::vector<std::vector<PlaceSum>> sums;  ///< of all blocks, by month, as the normals

  std::span<const PlaceSum> sums_of(const PointBlock& block, std::size_t month) const {
    return std::span(sums[month]).subspan(block.first_sum, block.end_sum - block.first_sum);
  }
};

/// The order of points in which those with the same set of gauges follow each other, and else the
/// order that they have. `sets` has one for each point.
template <typename Set>
std::vector<std::uint32_t> order_of(const std::vector<Set>& sets) {
  std::vector<std::uint32_t> order(sets.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return sets[a] < sets[b]; });
  return order;
}

template <typename Value>
std::vector<Value> in_order(const std::vector<Value>& values,
                            const std::vector<std::uint32_t>& order) {
  std::vector<Value> result;
  result.reserve(order.size());
  for (const std::uint32_t i : order) result.push_back(values[i]);
  return result;
}

/// Puts points into blocks, in the order that order_of gave for their sets of gauges.
/// `add(month, i)` adds to `weights` what gauges weigh at the point that is the i-th in that order.
template <typename Set, typename Add>
PointBlocks point_blocks(const std::vector<Set>& sets, const std::vector<std::uint32_t>& order,
                         std::size_t months, WeightSums& weights, const Add& add) {
  PointBlocks blocks;
  blocks.sums.resize(months);
  for (std::uint32_t first = 0; first < order.size();) {
    std::uint32_t end = first;
    while (end < order.size() && sets[order[end]] == sets[order[first]]) ++end;
    const auto first_sum = static_cast<std::uint32_t>(blocks.sums.front().size());
    for (std::size_t m = 0; m < months; ++m) {
      for (std::uint32_t i = first; i < end; ++i) add(m, i);
      const std::vector<PlaceSum> block = weights.take_sums();
      blocks.sums[m].insert(blocks.sums[m].end(), block.begin(), block.end());
    }
    const auto end_sum = static_cast<std::uint32_t>(blocks.sums.front().size());
    blocks.all.push_back({first, end, first_sum, end_sum});
    first = end;
  }
  return blocks;
}

}  // namespace thiessen
