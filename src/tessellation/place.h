#pragma once

#include <cstddef>
#include <cstdint>

namespace thiessen {

/// The index of the place that a cell belongs to: its position in the list of distinct positions,
/// from 0.
enum class PlaceIndex : std::uint32_t {};

constexpr std::size_t index(PlaceIndex i) {
  return static_cast<std::size_t>(i);
}

}  // namespace thiessen
