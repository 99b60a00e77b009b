#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen::fuzzers {

/// Fewer than `most`.
inline std::vector<std::uint8_t> any_bytes(Seeded& seeded, std::size_t most) {
  std::vector<std::uint8_t> bytes(seeded.below(most));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(seeded.below(256));
  return bytes;
}

template <typename Fuzz>
void expect_no_complaint(Fuzz fuzz, const std::vector<std::uint8_t>& bytes) {
  try {
    fuzz(bytes);
  } catch (const std::exception& error) {
    std::string text;
    for (const std::uint8_t byte : bytes) text += std::to_string(byte) + ",";
    FAIL() << error.what() << "\nwith the bytes " << text;
  }
}

}  // namespace thiessen::fuzzers
