#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace thiessen {

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

}  // namespace thiessen
