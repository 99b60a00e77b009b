#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace thiessen {

/// A whole number in so many bytes, the lowest first.
inline std::string little(std::uint64_t number, std::size_t bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes; ++i) text += static_cast<char>(number >> (8 * i) & 0xFF);
  return text;
}

/// The same, the highest byte first.
inline std::string big(std::uint64_t number, std::size_t bytes) {
  const std::string lowest_first = little(number, bytes);
  return {lowest_first.rbegin(), lowest_first.rend()};
}

/// The eight bytes of a double, the lowest first.
inline std::string little(double number) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  return little(bits, sizeof bits);
}

}  // namespace thiessen
