#include "base/secrets.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace thiessen {
namespace {

constexpr std::string_view mask = "***";

struct Span {
  std::size_t begin;
  std::size_t end;
};

bool is_blank(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

enum class Within { connection, sentence };

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool alike(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// Where a value that is not quoted ends: at the next `word=`, for a password may have blanks that
/// its user forgot to quote, and else at the last character that is no blank.
std::size_t end_of_words(std::string_view text, std::size_t begin) {
  for (std::size_t at = begin; at < text.size(); ++at) {
    if (!is_blank(text[at])) continue;
    std::size_t next = at;
    while (next < text.size() && is_blank(text[next])) ++next;
    std::size_t word = next;
    while (word < text.size() && is_word(text[word])) ++word;
    while (word < text.size() && is_blank(text[word])) ++word;
    if (word > next && word < text.size() && text[word] == '=') return at;
  }
  std::size_t end = text.size();
  while (end > begin && is_blank(text[end - 1])) --end;
  return end;
}

/// Where a value ends that stands in a sentence, whose signs are no part of it.
std::size_t end_of_word(std::string_view text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && !is_blank(text[end])) ++end;
  while (end > begin && (text[end - 1] == ':' || text[end - 1] == ',' || text[end - 1] == '\''))
    --end;
  return end;
}

std::size_t end_of_quotes(std::string_view text, std::size_t begin) {
  for (std::size_t at = begin + 1; at < text.size(); ++at) {
    if (text[at] == '\\') {
      ++at;
    } else if (text[at] == '\'') {
      return at + 1;
    }
  }
  return text.size();
}

/// The value of the first `password=` from a place on.
bool find_value(std::string_view text, Within within, std::size_t from, Span& value) {
  constexpr std::string_view name = "password";
  const auto found = std::search(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(),
                                 name.begin(), name.end(), alike);
  if (found == text.end()) return false;
  std::size_t at = static_cast<std::size_t>(found - text.begin()) + name.size();
  const std::size_t after = at;
  while (at < text.size() && is_blank(text[at])) ++at;
  if (at == text.size() || text[at] != '=') {
    return find_value(text, within, after, value);
  }
  ++at;
  while (at < text.size() && is_blank(text[at])) ++at;
  const bool quoted = at < text.size() && text[at] == '\'';
  value = {at, quoted                         ? end_of_quotes(text, at)
               : within == Within::connection ? end_of_words(text, at)
                                              : end_of_word(text, at)};
  return true;
}

/// The password of the first address `scheme://user:password@host` from a place on. It may hold an
/// unescaped `@`, so it ends at the last one before the path.
bool find_in_address(std::string_view text, std::size_t from, Span& password) {
  const std::size_t scheme = text.find("://", from);
  if (scheme == std::string_view::npos) return false;
  const std::size_t begin = scheme + 3;
  const std::size_t end = std::min(text.find_first_of(" \t\n/", begin), text.size());
  const std::string_view authority = text.substr(begin, end - begin);
  const std::size_t at = authority.rfind('@');
  const std::size_t colon = authority.find(':');
  if (at == std::string_view::npos || colon == std::string_view::npos || colon > at)
    return find_in_address(text, begin, password);
  password = {begin + colon + 1, begin + at};
  return true;
}

std::vector<Span> passwords_in(std::string_view text, Within within) {
  std::vector<Span> found;
  Span span{0, 0};
  for (std::size_t from = 0; find_value(text, within, from, span); from = span.end)
    found.push_back(span);
  for (std::size_t from = 0; find_in_address(text, from, span); from = span.end)
    found.push_back(span);
  std::sort(found.begin(), found.end(), [](Span a, Span b) { return a.begin < b.begin; });
  return found;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  if (what.empty()) return;
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

std::string masked(std::string_view text, Within within) {
  std::string clean;
  std::size_t done = 0;
  for (const Span span : passwords_in(text, within)) {
    if (span.begin < done) continue;
    clean += text.substr(done, span.begin - done);
    if (span.end > span.begin) clean += mask;
    done = span.end;
  }
  return clean += text.substr(done);
}

/// The value as it is meant, without the quotes that it may stand in.
std::string without_quotes(std::string_view value) {
  if (!value.starts_with('\'')) return std::string(value);
  value.remove_prefix(1);
  if (value.ends_with('\'')) value.remove_suffix(1);
  return std::string(value);
}

}  // namespace

std::string without_password(std::string_view connection) {
  return masked(connection, Within::connection);
}

std::string without_passwords(std::string_view sentence) {
  return masked(sentence, Within::sentence);
}

std::string without_secrets(std::string text, std::string_view connection) {
  text = without_passwords(text);
  constexpr std::size_t long_enough = 4;  // a shorter one would blot out innocent words
  for (const Span span : passwords_in(connection, Within::connection)) {
    const std::string password =
        without_quotes(connection.substr(span.begin, span.end - span.begin));
    if (password.size() >= long_enough) replace_all(text, password, std::string(mask));
    std::size_t at = 0;
    while (at < password.size()) {
      while (at < password.size() && is_blank(password[at])) ++at;
      std::size_t end = at;
      while (end < password.size() && !is_blank(password[end])) ++end;
      if (end > at)
        replace_all(text, '"' + password.substr(at, end - at) + '"', '"' + std::string(mask) + '"');
      at = end;
    }
  }
  return text;
}

}  // namespace thiessen
