#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace thiessen {

/// How much of a text is valid UTF-8.
struct Utf8Prefix {
  std::size_t valid = 0;  ///< how many bytes at the beginning are whole, valid characters
  /// Whether the rest may be a valid character that the text's end cuts off.
  bool truncated = false;
};

/// Finds the longest valid beginning of the text. Overlong forms, surrogates and anything above
/// U+10FFFF are invalid (RFC 3629). Cost: linear; several gigabytes a second where the text is
/// ASCII.
Utf8Prefix valid_utf8_prefix(std::string_view text);

/// The offset, from 0, of the first byte that is not UTF-8, or nothing where all is valid.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

/// The mark with which some programs begin a file in UTF-8.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Whether two texts are equal, where upper and lower case of A to Z count as the same, in any
/// locale.
bool equal_ignoring_case(std::string_view a, std::string_view b);

/// The text with A to Z changed to a to z, in any locale.
std::string lower_case(std::string_view text);

/// The text without the spaces and tabs at its ends.
std::string_view trimmed(std::string_view text);

/// The text in single quotes, for a message. Where it has more than `longest` bytes it is cut,
/// between characters, and ends in "...".
std::string quoted(std::string_view text, std::size_t longest = 400);

}  // namespace thiessen
