#pragma once

#include <cstddef>
#include <cstdint>

namespace thiessen {

/// A station's position in its file, from 0.
enum class StationIndex : std::uint32_t {};

constexpr std::size_t index(StationIndex i) {
  return static_cast<std::size_t>(i);
}

}  // namespace thiessen
