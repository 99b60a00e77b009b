#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace thiessen {

/// The code points of UTF-8 text. Bytes that are not UTF-8 become U+FFFD. Cost: the text.
std::u32string decoded(std::string_view utf8);

/// The code points of UTF-8 text as far as a picture can show them: bytes that are not UTF-8 become
/// U+FFFD, control characters and line breaks become spaces, and embeddings, overrides and
/// isolates, which turn the direction of the text in them, are left out. Cost: the text.
std::u32string displayable(std::string_view utf8);

std::string to_utf8(std::u32string_view text);

/// Whether a character takes no place of its own on a line: combining marks, joiners, variation
/// selectors.
bool is_attached(char32_t c);

/// Whether a character needs no glyph: joiners, variation selectors and other instructions to the
/// shaper.
bool is_invisible(char32_t c);

/// The first `length` code points of a longer text and an ellipsis, cut before a base character so
/// that no mark is parted from its letter; a text that is not longer stays as it is.
std::u32string shortened(std::u32string_view text, std::size_t length);

/// A stretch of text that is read in one direction.
struct DirectedRun {
  std::u32string text;  ///< in reading order
  bool right_to_left = false;
};

/// A line as runs of one direction, in their order from left to right, and its own direction: that
/// of its first letter that has one.
struct DirectedLine {
  std::vector<DirectedRun> runs;
  bool right_to_left = false;
};

/// Parts a line into runs by the Unicode bidirectional algorithm (UAX 9, by FriBidi). Throws
/// std::bad_alloc where memory runs out. Cost: the text.
DirectedLine directed_line(std::u32string_view text);

/// The text as it is to be given to a shaper that takes the direction from the first letter or
/// Arabic digit, left to right where there is none: in reverse where that is not the text's
/// direction, with brackets mirrored for right to left. Cost: the text.
std::u32string for_shaper(std::u32string_view text, bool right_to_left);

}  // namespace thiessen
