#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/utf8.h"

namespace thiessen::fuzzers {

/// A value of JSON, whole in memory.
struct Json {
  enum class Kind { object, array, string, number, literal };
  Kind kind = Kind::literal;
  std::string text;               ///< what a string says; a number or a literal as written
  std::vector<std::string> keys;  ///< of an object, in their order
  std::vector<Json> values;       ///< of an object or an array

  const Json* member(std::string_view key) const {
    const auto found = std::find(keys.begin(), keys.end(), key);
    return found == keys.end() ? nullptr : &values[static_cast<std::size_t>(found - keys.begin())];
  }
  bool is(std::string_view literal_or_text) const { return text == literal_or_text; }
};

/// RFC 8259 told once more, as the judge of JsonScanner: half a surrogate pair is refused, and a
/// byte order mark is passed over, as there.
class PlainJson {
 public:
  explicit PlainJson(std::string_view text) : rest_(text) {}

  /// The value that the text is; nothing where it is no JSON. Words such as NaN are read, though
  /// they are none.
  std::optional<Json> read() {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (find_invalid_utf8(rest_)) return std::nullopt;
    if (rest_.starts_with(mark)) rest_.remove_prefix(mark.size());
    Json json;
    if (!value(json)) return std::nullopt;
    pass_space();
    return rest_.empty() ? std::optional(std::move(json)) : std::nullopt;
  }
  /// Whether what was read is JSON without such words.
  bool is_strict() const { return is_strict_; }

 private:
  static constexpr std::string_view digits = "0123456789";

  void pass_space() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
  }
  bool take(std::string_view wanted) {
    if (!rest_.starts_with(wanted)) return false;
    rest_.remove_prefix(wanted.size());
    return true;
  }
  bool value(Json& json) {
    pass_space();
    if (rest_.starts_with('{')) return values(json, Json::Kind::object, "{", "}");
    if (rest_.starts_with('[')) return values(json, Json::Kind::array, "[", "]");
    if (rest_.starts_with('"')) {
      json.kind = Json::Kind::string;
      return string(json.text);
    }
    return word(json.text) || number(json);
  }
  bool word(std::string& text) {
    constexpr std::size_t longest = 16;
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    while (!rest_.empty() && is_letter(rest_[0]) && text.size() < longest) {
      text += rest_[0];
      rest_.remove_prefix(1);
    }
    is_strict_ =
        is_strict_ && (text.empty() || text == "true" || text == "false" || text == "null");
    return !text.empty();
  }
  bool values(Json& json, Json::Kind kind, std::string_view opening, std::string_view closing) {
    json.kind = kind;
    take(opening);
    pass_space();
    if (take(closing)) return true;
    do {
      if (kind == Json::Kind::object) {
        pass_space();
        if (!string(json.keys.emplace_back())) return false;
        pass_space();
        if (!take(":")) return false;
      }
      if (!value(json.values.emplace_back())) return false;
      pass_space();
    } while (take(","));
    return take(closing);
  }
  bool some_digits() {
    const std::size_t count = std::min(rest_.find_first_not_of(digits), rest_.size());
    rest_.remove_prefix(count);
    return count > 0;
  }
  bool number(Json& json) {
    json.kind = Json::Kind::number;
    const char* const begin = rest_.data();
    take("-");
    if (!take("0") && !some_digits()) return false;
    if (take(".") && !some_digits()) return false;
    if (take("e") || take("E")) {
      if (!take("+")) take("-");
      if (!some_digits()) return false;
    }
    json.text.assign(begin, rest_.data());
    return true;
  }

  bool string(std::string& text) {
    if (!take("\"")) return false;
    while (!rest_.empty() && rest_[0] != '"') {
      if (static_cast<unsigned char>(rest_[0]) < 0x20) return false;
      if (rest_[0] == '\\') {
        if (!escape(text)) return false;
      } else {
        text += rest_[0];
        rest_.remove_prefix(1);
      }
    }
    return take("\"");
  }
  bool escape(std::string& text) {
    constexpr std::string_view letters = "\"\\/bfnrt";
    constexpr std::string_view meant = "\"\\/\b\f\n\r\t";
    if (rest_.size() < 2) return false;
    const std::size_t which = letters.find(rest_[1]);
    if (which != std::string_view::npos) {
      rest_.remove_prefix(2);
      text += meant[which];
      return true;
    }
    char32_t code = 0;
    if (!half(code) || (code >= 0xDC00 && code < 0xE000)) return false;
    if (code >= 0xD800 && code < 0xDC00) {
      char32_t low = 0;
      if (!half(low) || low < 0xDC00 || low >= 0xE000) return false;
      code = 0x10000 + (code - 0xD800) * 0x400 + (low - 0xDC00);
    }
    append(text, code);
    return true;
  }
  /// Four digits after \u.
  bool half(char32_t& code) {
    if (!take("\\u") || rest_.size() < 4) return false;
    for (int i = 0; i < 4; ++i) {
      constexpr std::string_view hexadecimal = "0123456789abcdef";
      const std::size_t digit = hexadecimal.find(lower_case(rest_.substr(0, 1)));
      if (digit == std::string_view::npos) return false;
      code = code * 16 + static_cast<char32_t>(digit);
      rest_.remove_prefix(1);
    }
    return true;
  }
  static void append(std::string& text, char32_t code) {
    const auto tail = [&](int sixes) {
      text += static_cast<char>(0x80 | ((code >> (6 * sixes)) & 0x3F));
    };
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += static_cast<char>(0xC0 | (code >> 6));
      tail(0);
    } else if (code < 0x10000) {
      text += static_cast<char>(0xE0 | (code >> 12));
      tail(1);
      tail(0);
    } else {
      text += static_cast<char>(0xF0 | (code >> 18));
      tail(2);
      tail(1);
      tail(0);
    }
  }

  std::string_view rest_;
  bool is_strict_ = true;
};

}  // namespace thiessen::fuzzers
