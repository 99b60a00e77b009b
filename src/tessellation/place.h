#pragma once

#include <cstddef>
#include <cstdint>

namespace thiessen {

/// Which place a cell belongs to: a position in the list of distinct positions, from 0.
enum class PlaceIndex : std::uint32_t {};

constexpr std::size_t index(PlaceIndex i) {
  return static_cast<std::size_t>(i);
}

}  // namespace thiessen
