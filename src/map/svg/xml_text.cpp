#include "map/svg/xml_text.h"

#include <cstdint>

#include "base/hexadecimal.h"
#include "map/ink/unicode.h"

namespace thiessen {
namespace {

bool is_allowed(char32_t c) {
  return c == U'\t' || c == U'\n' || c == U'\r' || (c >= 0x20 && c != 0xFFFE && c != 0xFFFF);
}

}  // namespace

std::string xml_text(std::string_view utf8) {
  std::u32string text;
  for (const char32_t c : decoded(utf8)) {
    switch (c) {
      case U'&':
        text += U"&amp;";
        break;
      case U'<':
        text += U"&lt;";
        break;
      case U'>':
        text += U"&gt;";
        break;
      case U'"':
        text += U"&quot;";
        break;
      case U'\t':
        text += U"&#9;";
        break;
      case U'\n':
        text += U"&#10;";
        break;
      case U'\r':
        text += U"&#13;";
        break;
      default:
        text += is_allowed(c) ? c : U'\uFFFD';
    }
  }
  return to_utf8(text);
}

std::string hexadecimal(Colour colour) {
  std::string text = "#";
  for (const std::uint8_t channel : {colour.red, colour.green, colour.blue})
    append_hexadecimal(text, channel);
  return text;
}

}  // namespace thiessen
