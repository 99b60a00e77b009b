#pragma once

#include <cstdint>
#include <span>

namespace thiessen {

/// What is sorted: a rank in the high bits, and in the low ones the index of what has it.
using RankedIndex = std::uint64_t;
inline constexpr int ranked_index_bits = 32;

inline std::uint32_t index_of(RankedIndex entry) {
  return static_cast<std::uint32_t>(entry);
}

/// Sorts entries by rank, and keeps the order of those with one rank, which must be that of their
/// indices. Requires ranks of at most `bits` bits, and `spare` of the size of `entries`; returns
/// whichever of the two holds the result. Cost: linear; n log n for a few.
std::span<RankedIndex> sorted_by_rank(std::span<RankedIndex> entries, std::span<RankedIndex> spare,
                                      int bits);

}  // namespace thiessen
