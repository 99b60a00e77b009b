#include "rainfall/gauge_patterns.h"

#include <algorithm>
#include <cmath>

namespace thiessen {
namespace {

/// A multiplication and its high half folded in: each bit of the word moves half of the others.
std::uint64_t mixed(std::uint64_t hash, std::uint64_t word, std::uint64_t factor) {
  hash = (hash ^ word) * factor;
  return hash ^ (hash >> 32);
}

}  // namespace

GaugePatterns::Pattern GaugePatterns::of(std::span<const double> readings) {
  constexpr std::size_t word_bits = 64;
  Hash hash{readings.size(), ~std::uint64_t{readings.size()}};
  for (std::size_t first = 0; first < readings.size(); first += word_bits) {
    std::uint64_t word = 0;
    const std::size_t end = std::min(readings.size(), first + word_bits);
    for (std::size_t i = first; i < end; ++i)
      word |= std::uint64_t{std::isnan(readings[i])} << (i - first);
    hash[0] = mixed(hash[0], word, 0x9E3779B97F4A7C15u);
    hash[1] = mixed(hash[1], word, 0xD6E8FEB86659FD93u);
  }
  const auto [at, is_fresh] = number_.emplace(hash, number_.size() + 1);
  return {at->second, is_fresh};
}

}  // namespace thiessen
