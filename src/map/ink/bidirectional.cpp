#include <fribidi.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <numeric>

#include "map/ink/unicode.h"

namespace thiessen {
namespace {

using Levels = std::vector<FriBidiLevel>;
using Order = std::vector<FriBidiStrIndex>;

/// The embedding levels of a line: even ones run left to right, odd ones right to left.
struct Embedding {
  std::vector<FriBidiCharType> types;
  Levels levels;
  FriBidiParType base = FRIBIDI_PAR_ON;
};

Embedding embedding_of(std::u32string_view text) {
  const auto size = static_cast<FriBidiStrIndex>(text.size());
  const std::vector<FriBidiChar> characters(text.begin(), text.end());
  Embedding line{std::vector<FriBidiCharType>(text.size()), Levels(text.size())};
  std::vector<FriBidiBracketType> brackets(text.size());
  fribidi_get_bidi_types(characters.data(), size, line.types.data());
  fribidi_get_bracket_types(characters.data(), size, line.types.data(), brackets.data());
  if (fribidi_get_par_embedding_levels_ex(line.types.data(), brackets.data(), size, &line.base,
                                          line.levels.data()) == 0) {
    throw std::bad_alloc();
  }
  return line;
}

/// The places of the characters in reading order, from left to right.
Order from_left_to_right(Embedding& line) {
  Order order(line.levels.size());
  std::iota(order.begin(), order.end(), 0);
  const FriBidiFlags as_it_is = 0;
  if (fribidi_reorder_line(as_it_is, line.types.data(), static_cast<FriBidiStrIndex>(order.size()),
                           0, line.base, line.levels.data(), nullptr, order.data()) == 0) {
    throw std::bad_alloc();
  }
  return order;
}

/// Whether a shaper takes the text for one from right to left: by its first letter, or digit of a
/// script that runs so.
bool seems_right_to_left(std::u32string_view text) {
  for (const char32_t c : text) {
    const FriBidiCharType type = fribidi_get_bidi_type(c);
    const bool arabic = c >= 0x0600 && c <= 0x06FF && FRIBIDI_IS_WEAK(type) &&
                        type != FRIBIDI_TYPE_NSM && type != FRIBIDI_TYPE_CS;
    if (FRIBIDI_IS_STRONG(type) || arabic) return arabic || FRIBIDI_IS_RTL(type) != 0;
  }
  return false;
}

}  // namespace

DirectedLine directed_line(std::u32string_view text) {
  DirectedLine result;
  if (text.empty()) return result;
  Embedding line = embedding_of(text);
  const Order order = from_left_to_right(line);
  result.right_to_left = FRIBIDI_IS_RTL(line.base) != 0;
  const auto level = [&](std::size_t i) { return line.levels[static_cast<std::size_t>(order[i])]; };
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && level(end) == level(i) &&
           std::abs(order[end] - order[end - 1]) == 1)
      ++end;
    const auto first = static_cast<std::size_t>(std::min(order[i], order[end - 1]));
    result.runs.push_back({std::u32string(text.substr(first, end - i)), level(i) % 2 == 1});
    i = end;
  }
  return result;
}

std::u32string for_shaper(std::u32string_view text, bool right_to_left) {
  std::u32string given(text);
  if (seems_right_to_left(text) == right_to_left) return given;
  std::reverse(given.begin(), given.end());
  if (!right_to_left) return given;
  for (char32_t& c : given) {
    FriBidiChar mirrored = c;
    if (fribidi_get_mirror_char(c, &mirrored) != 0) c = mirrored;
  }
  return given;
}

}  // namespace thiessen
