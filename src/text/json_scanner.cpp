#include "text/json_scanner.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace thiessen {
namespace {

constexpr std::size_t kept_at_most = 256;
constexpr std::size_t longest_number = 4096;

bool is_digit(int byte) {
  return byte >= '0' && byte <= '9';
}

bool in_number(int byte) {
  return is_digit(byte) || byte == '-' || byte == '+' || byte == '.' || byte == 'e' || byte == 'E';
}

bool in_word(int byte) {
  return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z');
}

/// Whether the text matches -?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][+-]?[0-9]+)?
bool is_json_number(const std::string& text) {
  auto at = text.begin();
  const auto digits = [&] {
    const auto from = at;
    while (at != text.end() && is_digit(*at)) ++at;
    return at - from;
  };
  if (at != text.end() && *at == '-') ++at;
  const bool zero = at != text.end() && *at == '0';
  const auto whole = digits();
  if (whole == 0 || (zero && whole > 1)) return false;
  if (at != text.end() && *at == '.' && (++at, digits() == 0)) return false;
  if (at != text.end() && (*at == 'e' || *at == 'E')) {
    ++at;
    if (at != text.end() && (*at == '+' || *at == '-')) ++at;
    if (digits() == 0) return false;
  }
  return at == text.end();
}

}  // namespace

struct JsonScanner::Bytes {
  explicit Bytes(ByteSource& from) : source(from) {}

  int look() {
    if (at == size) {
      at = 0;
      size = source.read(buffer.data(), buffer.size());
      if (size == 0) return -1;
    }
    return static_cast<unsigned char>(buffer[at]);
  }

  ByteSource& source;
  std::array<char, 65536> buffer;
  std::size_t at = 0;
  std::size_t size = 0;
};

JsonScanner::JsonScanner(std::string file, ByteSource& source)
    : file_(std::move(file)), bytes_(std::make_unique<Bytes>(source)) {
  if (look() == 0xEF) {
    take();
    const int second = take();
    const int third = take();
    const auto continues = [](int byte) { return byte >= 0x80 && byte <= 0xBF; };
    if (!continues(second) || !continues(third)) fail("not UTF-8 at byte 0");
    if (second != 0xBB || third != 0xBF) fail("a value is expected, not " + shown(0xEF));
  }
}

JsonScanner::~JsonScanner() = default;

int JsonScanner::look() {
  return bytes_->look();
}

int JsonScanner::take() {
  const int byte = look();
  if (byte < 0) return byte;
  ++bytes_->at;
  ++offset_;
  if (byte == '\n') ++line_;
  return byte;
}

void JsonScanner::skip_space() {
  for (int byte = look(); byte == ' ' || byte == '\n' || byte == '\r' || byte == '\t';
       byte = look()) {
    take();
  }
}

std::string JsonScanner::shown(int byte) const {
  if (byte < 0) return "the end of the file";
  return "'" + printable(std::string(1, static_cast<char>(byte))) + "'";
}

void JsonScanner::fail(std::string text) const {
  throw Error(Message{file_, line_, "not whole JSON: " + std::move(text), {}});
}

JsonScanner::Kind JsonScanner::peek() {
  skip_space();
  const int byte = look();
  if (byte == '{') return Kind::object;
  if (byte == '[') return Kind::array;
  if (byte == '"') return Kind::string;
  if (byte == '-' || is_digit(byte)) return Kind::number;
  if (in_word(byte)) return Kind::literal;
  if (byte < 0) return Kind::end;
  fail("a value is expected, not " + shown(byte));
}

void JsonScanner::expect(char wanted) {
  skip_space();
  const int byte = look();
  if (byte != wanted) fail("'" + std::string(1, wanted) + "' is expected, not " + shown(byte));
  take();
}

void JsonScanner::colon() {
  expect(':');
}

bool JsonScanner::open(char opening, char closing) {
  expect(opening);
  skip_space();
  if (look() != closing) return true;
  take();
  return false;
}

bool JsonScanner::more(char closing) {
  skip_space();
  if (look() == ',') {
    take();
    return true;
  }
  expect(closing);
  return false;
}

void JsonScanner::require_end() {
  skip_space();
  if (look() >= 0) fail("text follows after the end: " + shown(look()));
}

const std::string& JsonScanner::number() {
  skip_space();
  text_.clear();
  while (in_number(look())) {
    if (text_.size() == longest_number) fail("a number is longer than 4096 characters");
    text_.push_back(static_cast<char>(take()));
  }
  if (!is_json_number(text_)) fail("'" + text_.substr(0, 40) + "' is no number");
  return text_;
}

const std::string& JsonScanner::literal() {
  skip_space();
  text_.clear();
  while (in_word(look()) && text_.size() < 16) text_.push_back(static_cast<char>(take()));
  return text_;
}

void JsonScanner::keep(int byte) {
  hash_ = (hash_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3U;
  if (text_.size() < kept_at_most) text_.push_back(static_cast<char>(byte));
}

unsigned JsonScanner::four_digits() {
  unsigned code = 0;
  for (int i = 0; i < 4; ++i) {
    const int byte = take();
    const int letter = byte | 0x20;
    if (is_digit(byte)) {
      code = code * 16 + static_cast<unsigned>(byte - '0');
    } else if (letter >= 'a' && letter <= 'f') {
      code = code * 16 + static_cast<unsigned>(letter - 'a' + 10);
    } else {
      fail("a string has a broken escape");
    }
  }
  return code;
}

void JsonScanner::escape() {
  const int byte = take();
  static const std::string letters = "\"\\/bfnrt";
  static const std::string meant = "\"\\/\b\f\n\r\t";
  if (const std::size_t which =
          byte < 0 ? std::string::npos : letters.find(static_cast<char>(byte));
      which != std::string::npos) {
    keep(meant[which]);
    return;
  }
  if (byte != 'u') fail("a string has a broken escape");
  unsigned code = four_digits();
  if (code >= 0xDC00 && code <= 0xDFFF) fail("a string has half of a surrogate pair");
  if (code >= 0xD800 && code <= 0xDBFF) {
    if (take() != '\\' || take() != 'u') fail("a string has half of a surrogate pair");
    const unsigned low = four_digits();
    if (low < 0xDC00 || low > 0xDFFF) fail("a string has half of a surrogate pair");
    code = 0x10000 + ((code - 0xD800) << 10U) + (low - 0xDC00);
  }
  if (code < 0x80) {
    keep(static_cast<int>(code));
  } else if (code < 0x800) {
    keep(static_cast<int>(0xC0 | (code >> 6U)));
    keep(static_cast<int>(0x80 | (code & 0x3FU)));
  } else if (code < 0x10000) {
    keep(static_cast<int>(0xE0 | (code >> 12U)));
    keep(static_cast<int>(0x80 | ((code >> 6U) & 0x3FU)));
    keep(static_cast<int>(0x80 | (code & 0x3FU)));
  } else {
    keep(static_cast<int>(0xF0 | (code >> 18U)));
    keep(static_cast<int>(0x80 | ((code >> 12U) & 0x3FU)));
    keep(static_cast<int>(0x80 | ((code >> 6U) & 0x3FU)));
    keep(static_cast<int>(0x80 | (code & 0x3FU)));
  }
}

/// Reads the bytes of a UTF-8 character after its first. Refuses overlong forms, surrogates and
/// anything past U+10FFFF.
void JsonScanner::continuation(int lead) {
  const std::string at = "not UTF-8 at byte " + std::to_string(offset_ - 1);
  const int count = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
  if (lead < 0xC2 || lead > 0xF4) fail(at);
  keep(lead);
  for (int i = 0; i < count; ++i) {
    const int byte = take();
    int lowest = 0x80;
    int highest = 0xBF;
    if (i == 0 && lead == 0xE0) lowest = 0xA0;
    if (i == 0 && lead == 0xED) highest = 0x9F;
    if (i == 0 && lead == 0xF0) lowest = 0x90;
    if (i == 0 && lead == 0xF4) highest = 0x8F;
    if (byte < lowest || byte > highest) fail(at);
    keep(byte);
  }
}

const std::string& JsonScanner::string() {
  const std::size_t opened = (skip_space(), line_);
  expect('"');
  text_.clear();
  hash_ = 0xcbf29ce484222325U;
  for (;;) {
    const int byte = take();
    if (byte == '"') return text_;
    if (byte < 0) fail("a string that opens in line " + std::to_string(opened) + " does not close");
    if (byte < 0x20) fail("a string holds the control character " + shown(byte));
    if (byte == '\\') {
      escape();
    } else if (byte >= 0x80) {
      continuation(byte);
    } else {
      keep(byte);
    }
  }
}

}  // namespace thiessen
