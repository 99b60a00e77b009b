#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace thiessen {

/// How far a text is UTF-8.
struct Utf8Prefix {
  std::size_t valid = 0;  ///< bytes of whole, valid characters at the beginning
  bool truncated =
      false;  ///< what follows them may be a valid character that the text's end cuts off
};

/// The longest valid beginning. Overlong forms, surrogates and anything above U+10FFFF are invalid
/// (RFC 3629). Linear; several gigabytes a second where the text is ASCII.
Utf8Prefix valid_utf8_prefix(std::string_view text);

/// The offset, from 0, of the first byte that is not UTF-8; none where all is valid.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

/// Whether two texts are the same but for the case of the letters A to Z, in any locale.
bool equal_ignoring_case(std::string_view a, std::string_view b);

/// The text with A to Z as a to z, in any locale.
std::string lower_case(std::string_view text);

/// The text without the spaces and tabs at its ends.
std::string_view trimmed(std::string_view text);

/// The text in single quotes for a message; beyond `longest` bytes it is cut, between characters,
/// and ends in "...".
std::string quoted(std::string_view text, std::size_t longest = 400);

}  // namespace thiessen
