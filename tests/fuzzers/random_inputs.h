#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen::fuzzers {

/// Fewer than `most`.
inline std::vector<std::uint8_t> any_bytes(Seeded& seeded, std::size_t most) {
  std::vector<std::uint8_t> bytes(seeded.below(most));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(seeded.below(256));
  return bytes;
}

/// Fewer than `most` of the words, in any order, and now and then any byte.
inline std::string any_words(Seeded& seeded, std::span<const std::string_view> words,
                             std::size_t most) {
  std::string text;
  for (std::size_t count = seeded.below(most); count > 0; --count) {
    text += words[seeded.below(words.size())];
    if (seeded.below(200) == 0) text += static_cast<char>(seeded.below(256));
  }
  return text;
}

/// A sound text with up to `most` damages: a byte changed, left out or put in, a piece left out,
/// doubled or moved, the end cut off.
inline std::string damaged(Seeded& seeded, std::string text, std::size_t most = 4) {
  using namespace std::literals;
  constexpr std::string_view odd = "\0\n\r\t \"',;.-+0129eE[]{}:\\\x7F\xC3\xEF\xFF"sv;
  for (std::size_t damages = seeded.below(most + 1); damages > 0 && !text.empty(); --damages) {
    const std::size_t at = seeded.below(text.size());
    const std::string piece = text.substr(at, 1 + seeded.below(1 + seeded.below(40)));
    switch (seeded.below(8)) {
      case 0:
        text[at] = static_cast<char>(seeded.below(256));
        break;
      case 1:
        text[at] = odd[seeded.below(odd.size())];
        break;
      case 2:
        text.insert(at, 1, odd[seeded.below(odd.size())]);
        break;
      case 3:
        text.erase(at, piece.size());
        break;
      case 4:
        text.insert(at, piece);
        break;
      case 5:
        text.erase(at, piece.size());
        text.insert(seeded.below(text.size() + 1), piece);
        break;
      case 6:
        text.erase(at, 1);
        break;
      default:
        if (seeded.below(4) == 0) text.resize(at);
    }
  }
  return text;
}

/// A text behind the bytes that decide how it is read.
inline std::vector<std::uint8_t> input_of(std::initializer_list<std::uint64_t> decisions,
                                          std::string_view text) {
  std::vector<std::uint8_t> bytes;
  for (const std::uint64_t decision : decisions)
    bytes.push_back(static_cast<std::uint8_t>(decision));
  bytes.insert(bytes.end(), text.begin(), text.end());
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
