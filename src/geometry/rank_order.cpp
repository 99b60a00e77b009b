#include "geometry/rank_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/interrupt.h"

namespace thiessen {

// Few are sorted by comparison, many digit by digit.
std::span<RankedIndex> sorted_by_rank(std::span<RankedIndex> entries, std::span<RankedIndex> spare,
                                      int bits) {
  constexpr std::size_t few = 256;
  constexpr int widest_digit = 10;
  if (entries.size() < few) {
    std::sort(entries.begin(), entries.end());
    return entries;
  }
  const int digits = (bits + widest_digit - 1) / widest_digit;
  const int width = (bits + digits - 1) / digits;
  const RankedIndex mask = (RankedIndex{1} << width) - 1;
  for (int digit = 0; digit < digits; ++digit) {
    throw_if_interrupted();
    const int shift = ranked_index_bits + digit * width;
    std::array<std::uint32_t, std::size_t{1} << widest_digit> next{};
    for (const RankedIndex entry : entries) ++next[entry >> shift & mask];
    std::uint32_t begin = 0;
    for (std::uint32_t& place : next) begin += std::exchange(place, begin);
    for (const RankedIndex entry : entries) spare[next[entry >> shift & mask]++] = entry;
    std::swap(entries, spare);
  }
  return entries;
}

}  // namespace thiessen
