#include "cli/terminal/messages.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <initializer_list>
#include <iostream>

#include "base/secrets.h"

namespace thiessen::cli {
namespace {

/// A text as a shell takes it for one word and for nothing else. One with single quotes stands in
/// double ones, which are read more easily than quotes within quotes.
std::string in_shell(std::string_view text) {
  constexpr std::string_view plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-.,:/+=@%^";
  if (text.find_first_not_of(plain) == std::string_view::npos) return std::string(text);
  if (text.find('\'') == std::string_view::npos) return "'" + std::string(text) + "'";
  std::string word = "\"";
  for (const char c : text) {
    if (std::string_view("\"\\$`").find(c) != std::string_view::npos) word += '\\';
    word += c;
  }
  return word + "\"";
}

std::string option(std::string_view name, std::string_view value) {
  std::string text = "--" + std::string(name);
  std::replace(text.begin(), text.end(), '_', '-');
  if (value.empty()) return text;
  // The sign `=` keeps a negative number from being read as an option, as it would be after a
  // space.
  return text + (value.starts_with('-') ? "=" : " ") + in_shell(value);
}

std::string argument(std::string_view name) {
  std::string text(name);
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

/// Takes no memory.
void write_plainly(std::initializer_list<std::string_view> texts) noexcept {
  for (const std::string_view text : texts) {
    if (::write(STDERR_FILENO, text.data(), text.size()) < 0) errno = 0;
  }
}

}  // namespace

std::string shown(const Wording& words) {
  return printable(words.text({option, argument}));
}

void print(std::string_view before, const Message& message) {
  print(before, shown(message.placed()), shown(message.hint));
}

void print(std::string_view before, const std::string& text, const std::string& hint) {
  std::cerr << before << without_passwords(text) << '\n';
  if (!hint.empty()) print_hint(hint);
}

void print_hint(const std::string& hint) {
  std::cerr << "hint: " << without_passwords(hint) << '\n';
}

void print(std::string_view before, const Error& error) {
  for (const Message& message : error.messages()) print(before, message);
  if (error.unlisted() > 0) print(before, "and " + std::to_string(error.unlisted()) + " more", "");
}

void print_lack_of_memory(std::string_view what) noexcept {
  write_plainly({"thiessen: error: not enough memory", what.empty() ? "" : " ", what, "\n"});
}

void print_last_words(std::string_view words) noexcept {
  write_plainly({"thiessen: error: ", words, "\n"});
}

void print(Warnings& warnings) {
  for (const Message& message : warnings.notices()) print("thiessen: notice: ", message);
  for (const Message& message : warnings.messages()) print("thiessen: warning: ", message);
  warnings.have_been_told();
}

}  // namespace thiessen::cli
