#include "base/error.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "base/secrets.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::array<char, 17> hex_digits = {"0123456789abcdef"};

void append_hex(std::string& out, std::uint32_t value, int digits) {
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
    out += hex_digits[(value >> shift) & 0xFu];
  }
}

std::uint32_t decode(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first;
  std::uint32_t value = first & (0x7Fu >> character.size());
  for (const char c : character.substr(1)) {
    value = value << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
  }
  return value;
}

std::size_t length_of(char first) {
  const auto lead = static_cast<unsigned char>(first);
  if (lead < 0x80) return 1;
  return lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
}

/// Whether a terminal obeys the character instead of showing it: controls, line separators, and
/// marks that turn the direction of the text around them.
bool is_control(std::uint32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x061C || c == 0x200E || c == 0x200F ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF;
}

void append_printable(std::string& out, std::string_view character) {
  const std::uint32_t value = decode(character);
  if (!is_control(value)) {
    out += character;
  } else if (value < 0x80) {
    out += "\\x";
    append_hex(out, value, 2);
  } else {
    out += "\\u";
    append_hex(out, value, 4);
  }
}

std::string sentences(const std::vector<Message>& messages, std::size_t unlisted) {
  std::string all;
  for (const Message& message : messages) {
    if (!all.empty()) all += '\n';
    all += message.sentence();
  }
  if (unlisted > 0) all += "\nand " + std::to_string(unlisted) + " more";
  return all;
}

/// Forgets a hint that has been told already: what differs is easier to see without its repeats.
void tell_once(Wording& hint, std::vector<Wording>& told) {
  if (hint.empty()) return;
  constexpr std::size_t remembered = 100;  // so that the cost stays linear
  if (std::find(told.begin(), told.end(), hint) != told.end()) {
    hint = {};
  } else if (told.size() < remembered) {
    told.push_back(hint);
  }
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    std::string_view valid = text.substr(0, valid_utf8_prefix(text).valid);
    text.remove_prefix(valid.size());
    while (!valid.empty()) {
      const std::size_t length = length_of(valid[0]);
      append_printable(out, valid.substr(0, length));
      valid.remove_prefix(length);
    }
    if (text.empty()) break;
    out += "\\x";
    append_hex(out, static_cast<unsigned char>(text[0]), 2);
    text.remove_prefix(1);
  }
  return out;
}

Wording Message::placed() const {
  if (file.empty()) return text;
  return without_password(file) + (line > 0 ? ":" + std::to_string(line) : "") + ": " + text;
}

std::string Message::sentence() const {
  return printable(without_passwords(placed().plain()));
}

Error::Error(Message message) : messages_{std::move(message)}, what_(sentences(messages_, 0)) {}

Error::Error(std::vector<Message> messages, std::size_t unlisted)
    : messages_(std::move(messages)), unlisted_(unlisted), what_(sentences(messages_, unlisted)) {
  std::vector<Wording> told;
  for (Message& message : messages_) tell_once(message.hint, told);
}

void Warnings::add(Message message) {
  tell_once(message.hint, hints_);
  messages_.push_back(std::move(message));
}

void Complaints::add(Message message) {
  if (messages_.size() < listed_at_most) {
    messages_.push_back(std::move(message));
  } else {
    ++unlisted_;
  }
}

void Complaints::add_by_line(Message message) {
  const auto after =
      std::upper_bound(messages_.begin(), messages_.end(), message,
                       [](const Message& a, const Message& b) { return a.line < b.line; });
  messages_.insert(after, std::move(message));
  if (messages_.size() <= listed_at_most) return;
  messages_.pop_back();
  ++unlisted_;
}

void Complaints::merge(const std::vector<Message>& messages, std::size_t unlisted) {
  messages_.insert(messages_.end(), messages.begin(), messages.end());
  std::stable_sort(messages_.begin(), messages_.end(),
                   [](const Message& a, const Message& b) { return a.line < b.line; });
  unlisted_ += unlisted;
  if (messages_.size() > listed_at_most) {
    unlisted_ += messages_.size() - listed_at_most;
    messages_.resize(listed_at_most);
  }
}

void Complaints::throw_if_any() {
  if (!empty()) throw Error(std::exchange(messages_, {}), std::exchange(unlisted_, 0));
}

void Complaints::fail(const Message& last) {
  // The reason why reading stopped is listed, however many rows were bad before.
  if (messages_.size() >= listed_at_most) {
    unlisted_ += messages_.size() - (listed_at_most - 1);
    messages_.resize(listed_at_most - 1);
  }
  add(Error(last));
  throw Error(std::exchange(messages_, {}), std::exchange(unlisted_, 0));
}

}  // namespace thiessen
