#pragma once

#include <string>
#include <string_view>

namespace thiessen {

/// Appends a byte as two hexadecimal digits, a to f in lower case.
inline void append_hexadecimal(std::string& text, unsigned char byte) {
  constexpr std::string_view digits = "0123456789abcdef";
  text += digits[byte / 16U];
  text += digits[byte % 16U];
}

}  // namespace thiessen
