#include "map/ink/unicode.h"

#include <fribidi.h>

#include <array>
#include <cstdint>

namespace thiessen {
namespace {

struct Range {
  char32_t first;
  char32_t last;
};

template <std::size_t n>
bool within(char32_t c, const std::array<Range, n>& ranges) {
  for (const Range& r : ranges) {
    if (c >= r.first && c <= r.last) return true;
  }
  return false;
}

/// A code point, and the number of bytes that encode it.
struct Decoded {
  char32_t code;
  std::size_t length;
};

constexpr char32_t replacement = 0xFFFD;

Decoded first_of(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || bytes.size() < length) return {replacement, 1};
  char32_t code = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {replacement, 1};
    code = (code << 6) | (byte(i) & 0x3Fu);
  }
  constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < least[length] || code > 0x10FFFF || surrogate) return {replacement, 1};
  return {code, length};
}

bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x2028 || c == 0x2029;
}

/// Whether a character would turn the direction of what stands beside it, or tells a program
/// something that no picture shows.
bool is_instruction(char32_t c) {
  const FriBidiCharType type = fribidi_get_bidi_type(c);
  if (FRIBIDI_IS_EXPLICIT(type) || FRIBIDI_IS_ISOLATE(type)) return true;
  return type == FRIBIDI_TYPE_BN && !is_invisible(c);
}

}  // namespace

std::u32string decoded(std::string_view utf8) {
  std::u32string text;
  while (!utf8.empty()) {
    const Decoded next = first_of(utf8);
    utf8.remove_prefix(next.length);
    text.push_back(next.code);
  }
  return text;
}

std::u32string displayable(std::string_view utf8) {
  std::u32string text;
  for (const char32_t c : decoded(utf8)) {
    if (is_control(c)) {
      text.push_back(U' ');
    } else if (!is_instruction(c)) {
      text.push_back(c);
    }
  }
  return text;
}

std::string to_utf8(std::u32string_view text) {
  std::string bytes;
  for (const char32_t c : text) {
    if (c < 0x80) {
      bytes.push_back(static_cast<char>(c));
      continue;
    }
    const int tail = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    constexpr std::array<std::uint32_t, 4> lead{0, 0xC0, 0xE0, 0xF0};
    bytes.push_back(static_cast<char>(lead[static_cast<std::size_t>(tail)] | (c >> (6 * tail))));
    for (int i = tail - 1; i >= 0; --i) {
      bytes.push_back(static_cast<char>(0x80u | ((c >> (6 * i)) & 0x3Fu)));
    }
  }
  return bytes;
}

bool is_invisible(char32_t c) {
  constexpr std::array<Range, 7> ranges{{{0x00AD, 0x00AD},
                                         {0x034F, 0x034F},
                                         {0x061C, 0x061C},
                                         {0x180B, 0x180F},
                                         {0x200B, 0x200F},
                                         {0x2060, 0x2064},
                                         {0xFE00, 0xFE0F}}};
  return within(c, ranges);
}

bool is_attached(char32_t c) {
  return fribidi_get_bidi_type(c) == FRIBIDI_TYPE_NSM || is_invisible(c);
}

std::u32string shortened(std::u32string_view text, std::size_t length) {
  if (text.size() <= length) return std::u32string(text);
  while (length > 0 && is_attached(text[length])) --length;
  while (length > 0 && text[length - 1] == U' ') --length;
  return std::u32string(text.substr(0, length)) + U'…';
}

}  // namespace thiessen
