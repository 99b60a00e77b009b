#include "rainfall/series/gauge_patterns.h"

#include <algorithm>
#include <cmath>

namespace thiessen {
namespace {

/// Mixes bits so that each changes half of the others, wherever it stands (the last steps of
/// SplitMix64: G. L. Steele, D. Lea and C. H. Flood, Fast splittable pseudorandom number
/// generators, 2014).
std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
  return bits ^ (bits >> 31);
}

}  // namespace

GaugePatterns::Pattern GaugePatterns::of(std::span<const double> readings, std::size_t month) {
  constexpr std::size_t word_bits = 64;
  Hash hash{readings.size(), ~std::uint64_t{readings.size()}};
  for (std::size_t first = 0; first < readings.size(); first += word_bits) {
    std::uint64_t word = 0;
    const std::size_t end = std::min(readings.size(), first + word_bits);
    for (std::size_t i = first; i < end; ++i)
      word |= std::uint64_t{std::isnan(readings[i])} << (i - first);
    hash[0] = mixed(hash[0] ^ word);
    hash[1] = mixed((hash[1] ^ word) * 0x9E3779B97F4A7C15u + 1);
  }
  if (month > 0) hash = {mixed(hash[0] ^ month), mixed(hash[1] + month)};
  const auto [at, is_fresh] = number_.emplace(hash, number_.size() + 1);
  return {at->second, is_fresh};
}

}  // namespace thiessen
