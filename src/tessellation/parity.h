#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "tessellation/topology.h"

namespace thiessen {

/// The parity of the permutation that takes one order of points to another: an even or an odd
/// number of swaps, or `none` where the points are not the same.
enum class Parity { none, even, odd };

/// The parity of the permutation from `from` to `to`, in which only the first `count` points are
/// looked at.
template <std::size_t Length>
Parity parity(std::array<PointId, Length> from, const std::array<PointId, Length>& to,
              std::size_t count = Length) {
  const auto end = from.begin() + static_cast<std::ptrdiff_t>(count);
  Parity parity = Parity::even;
  for (std::size_t i = 0; i < count; ++i) {
    const auto there = std::find(from.begin() + static_cast<std::ptrdiff_t>(i), end, to[i]);
    if (there == end) return Parity::none;
    if (*there == from[i]) continue;
    std::iter_swap(from.begin() + static_cast<std::ptrdiff_t>(i), there);
    parity = parity == Parity::even ? Parity::odd : Parity::even;
  }
  return parity;
}

}  // namespace thiessen
