#pragma once

#include <cstdint>
#include <string_view>

namespace thiessen {

/// The unsigned whole number of `bytes`, the least significant byte first. Requires 8 at most.
inline std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (auto byte = bytes.rbegin(); byte != bytes.rend(); ++byte)
    value = value << 8U | static_cast<unsigned char>(*byte);
  return value;
}

/// The unsigned whole number of `bytes`, the most significant byte first. Requires 8 at most.
inline std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8U | static_cast<unsigned char>(byte);
  return value;
}

}  // namespace thiessen
