#include "base/utf8.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace thiessen {
namespace {

unsigned char byte(char c) {
  return static_cast<unsigned char>(c);
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

std::size_t ascii_prefix(std::string_view text) {
  std::size_t at = 0;
  for (; at + 32 <= text.size(); at += 32) {
    std::uint64_t words[4];
    std::memcpy(words, text.data() + at, sizeof words);
    if (((words[0] | words[1] | words[2] | words[3]) & 0x8080808080808080u) != 0) break;
  }
  while (at < text.size() && byte(text[at]) < 0x80) ++at;
  return at;
}

/// The form of a character as its first byte announces it: its length, and the range of its second
/// byte.
struct Lead {
  std::size_t length = 0;  ///< 0 where no character begins with the byte
  unsigned char second_low = 0x80;
  unsigned char second_high = 0xBF;
};

Lead lead_of(unsigned char first) {
  if (first < 0x80) return {1};
  if (first < 0xC2) return {};
  if (first < 0xE0) return {2};
  if (first == 0xE0) return {3, 0xA0, 0xBF};  // below: overlong
  if (first == 0xED) return {3, 0x80, 0x9F};  // above: surrogates
  if (first < 0xF0) return {3};
  if (first == 0xF0) return {4, 0x90, 0xBF};  // below: overlong
  if (first < 0xF4) return {4};
  if (first == 0xF4) return {4, 0x80, 0x8F};  // above: beyond U+10FFFF
  return {};
}

enum class Verdict { valid, invalid, truncated };

Verdict judge(std::string_view rest, const Lead& lead) {
  if (lead.length == 0) return Verdict::invalid;
  for (std::size_t i = 1; i < lead.length; ++i) {
    if (i == rest.size()) return Verdict::truncated;
    const unsigned char low = i == 1 ? lead.second_low : 0x80;
    const unsigned char high = i == 1 ? lead.second_high : 0xBF;
    if (byte(rest[i]) < low || byte(rest[i]) > high) return Verdict::invalid;
  }
  return Verdict::valid;
}

}  // namespace

Utf8Prefix valid_utf8_prefix(std::string_view text) {
  std::size_t at = ascii_prefix(text);
  while (at < text.size()) {
    const Lead lead = lead_of(byte(text[at]));
    const Verdict verdict = judge(text.substr(at), lead);
    if (verdict != Verdict::valid) return {at, verdict == Verdict::truncated};
    at += lead.length;
    if (lead.length == 1) at += ascii_prefix(text.substr(at));
  }
  return {at, false};
}

std::optional<std::size_t> find_invalid_utf8(std::string_view text) {
  const std::size_t valid = valid_utf8_prefix(text).valid;
  return valid == text.size() ? std::nullopt : std::optional(valid);
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char c, char d) { return lower(c) == lower(d); });
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), lower);
  return result;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string quoted(std::string_view text, std::size_t longest) {
  std::size_t end = std::min(text.size(), longest);
  while (end > 0 && end < text.size() && (byte(text[end]) & 0xC0) == 0x80) --end;
  std::string out = "'";
  out += text.substr(0, end);
  out += end < text.size() ? "...'" : "'";
  return out;
}

}  // namespace thiessen
