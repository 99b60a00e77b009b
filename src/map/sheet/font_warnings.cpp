#include "map/sheet/font_warnings.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "map/ink/unicode.h"

namespace thiessen {
namespace {

/// A few characters, apart from each other: side by side they would look like a garbled word.
std::string some_of(std::u32string_view characters) {
  constexpr std::size_t listed = 5;
  std::size_t count = 0;
  std::string some;
  for (const char32_t c : characters) {
    if (count == listed || c == U' ' || is_attached(c)) continue;
    some += (count == 0 ? "" : ", ") + to_utf8({&c, 1});
    ++count;
  }
  return some;
}

/// Words as they stand in the picture; long ones, as whole lines without spaces are, by their
/// beginning.
std::string words_of(const std::vector<std::u32string>& words) {
  constexpr std::size_t longest = 20;
  std::string text;
  for (const std::u32string& word : words)
    text += (text.empty() ? "" : ", ") + to_utf8(shortened(word, longest));
  return text;
}

/// Debian's packages of fonts with the outlines of these characters.
std::string packages_for(std::u32string_view characters) {
  const auto is_east_asian = [](char32_t c) {
    return (c >= 0x1100 && c <= 0x11FF) || (c >= 0x2E80 && c <= 0xA4CF) ||
           (c >= 0xAC00 && c <= 0xD7FF) || (c >= 0xF900 && c <= 0xFAFF) ||
           (c >= 0xFF00 && c <= 0xFFEF) || (c >= 0x20000 && c <= 0x3FFFF);
  };
  const auto is_other = [&](char32_t c) { return c != U' ' && !is_east_asian(c); };
  const bool east_asian = std::any_of(characters.begin(), characters.end(), is_east_asian);
  const bool other = std::any_of(characters.begin(), characters.end(), is_other);
  if (east_asian && other) return "fonts-noto-cjk and fonts-noto-core";
  return east_asian ? "fonts-noto-cjk" : "fonts-noto-core";
}

}  // namespace

void warn_of_fonts(const Typesetter& type, Warnings& warnings) {
  if (!type.missing().empty()) {
    warnings.add({{},
                  0,
                  "no installed font shows " + std::to_string(type.missing().size()) +
                      " of the picture's characters, such as " + some_of(type.missing()),
                  "install fonts for their script, such as fonts-noto-core, fonts-noto-cjk or "
                  "fonts-unifont"});
  }
  if (type.coarse_words().empty()) return;
  warnings.add_notice({{},
                       0,
                       "some of the picture's words, such as " + words_of(type.coarse_words()) +
                           ", are drawn from bitmaps, whose letters do not join",
                       "install a font with their outlines: " + packages_for(type.coarse())});
}

}  // namespace thiessen
