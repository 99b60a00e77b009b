#include "text/json_text.h"

#include <algorithm>

#include "base/utf8.h"

namespace thiessen {
namespace {

void append_escape(std::string& out, unsigned code) {
  constexpr std::string_view digits = "0123456789abcdef";
  out += "\\u";
  for (int shift = 12; shift >= 0; shift -= 4) {
    out += digits[(code >> static_cast<unsigned>(shift)) & 0xFU];
  }
}

/// Whether a text is written as it stands: ASCII, with nothing to escape.
bool is_plain(std::string_view text) {
  return std::ranges::all_of(
      text, [](char c) { return c >= 0x20 && c < 0x7F && c != '"' && c != '\\' && c != '<'; });
}

/// Appends the text with what JSON requires escaped. Requires that all of it is UTF-8.
void append_valid(std::string& out, std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto byte = static_cast<unsigned char>(c);
    const std::string_view three = text.substr(i, 3);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7F || c == '<') {
      append_escape(out, byte);
    } else if (three == "\xE2\x80\xA8" || three == "\xE2\x80\xA9") {
      append_escape(out, three[2] == '\xA8' ? 0x2028 : 0x2029);
      i += 2;
    } else {
      out += c;
    }
  }
}

}  // namespace

void append_json_string(std::string& out, std::string_view text) {
  out += '"';
  if (is_plain(text)) {
    out += text;
    out += '"';
    return;
  }
  for (;;) {
    const Utf8Prefix prefix = valid_utf8_prefix(text);
    append_valid(out, text.substr(0, prefix.valid));
    if (prefix.valid == text.size()) break;
    out += "\\ufffd";
    text.remove_prefix(prefix.valid + 1);
  }
  out += '"';
}

}  // namespace thiessen
