#include "text/field_names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/enumeration.h"
#include "base/error.h"
#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

/// Whether the text matches -?(0|[1-9][0-9]*) and is short enough for 64 bits.
bool is_plain_integer(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  if (text.empty() || text.size() > 18 || (text.size() > 1 && text.front() == '0')) return false;
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_plain_real(std::string_view text) {
  if (!parse_number(text) || text.starts_with('+')) return false;
  if (text.starts_with('-')) text.remove_prefix(1);
  const bool padded = text.size() > 1 && text[0] == '0' && text[1] >= '0' && text[1] <= '9';
  const bool whole = text.find_first_of(".eE") == std::string_view::npos;
  return !padded && !whole;
}

/// The name without a remark in brackets at its end that only says decimal degrees, as in
/// `Longitude (°)`. A remark that says anything else, such as minutes, stays.
std::string_view without_degrees(std::string_view name) {
  constexpr std::array<std::string_view, 16> says_degrees = {"°",
                                                             "deg",
                                                             "deg.",
                                                             "degree",
                                                             "degrees",
                                                             "decimal",
                                                             "decimal degree",
                                                             "dd",
                                                             "decimal degrees",
                                                             "decimal_degrees",
                                                             "grad",
                                                             "度",
                                                             "wgs84",
                                                             "wgs 84",
                                                             "wgs-84",
                                                             "degrees decimal"};
  for (const auto& [open, close] :
       {std::pair<std::string_view, std::string_view>{"(", ")"}, {"[", "]"}, {"（", "）"}}) {
    const std::size_t at = name.find(open);
    if (at == std::string_view::npos || at == 0 || !name.ends_with(close)) continue;
    std::string_view remark = name.substr(at + open.size());
    remark.remove_suffix(close.size());
    const std::string words = lower_case(trimmed(remark));
    const bool says =
        std::find(says_degrees.begin(), says_degrees.end(), words) != says_degrees.end();
    if (says) return trimmed(name.substr(0, at));
  }
  return name;
}

/// A letter of ASCII as plain_name writes it.
constexpr char plain_letter(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
  return c == ' ' || c == '-' ? '_' : c;
}

/// Whether plain_name changes nothing about a name but its letters, one by one: thousands of names
/// of stations are compared with all known names of fields.
bool is_bare(std::string_view name) {
  return std::ranges::none_of(name, [](char c) {
    return c == '.' || c == '(' || c == '[' || static_cast<unsigned char>(c) >= 0x80;
  });
}

}  // namespace

std::string plain_name(std::string_view name) {
  const auto parts = [](char c) { return c == ' ' || c == '-' || c == '_'; };
  const std::string text = lower_case(without_degrees(trimmed(name)));
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    // The full stop of an abbreviation, as in `geogr. Länge`, parts no words by itself.
    const bool shortens = text[i] == '.' && i > 0 && (i + 1 == text.size() || parts(text[i + 1]));
    if (!shortens) plain += parts(text[i]) || text[i] == '.' ? '_' : text[i];
  }
  for (std::size_t i = 0; i + 1 < plain.size(); ++i) {
    // U+00C0 to U+00DE are the capitals of U+00E0 to U+00FE, but for U+00D7, the sign of times.
    if (plain[i] != '\xC3') continue;
    const auto second = static_cast<unsigned char>(plain[i + 1]);
    if (second <= 0x9E && second != 0x97) plain[i + 1] = static_cast<char>(second + 0x20);
  }
  return plain;
}

bool same_name(std::string_view a, std::string_view b) {
  a = trimmed(a);
  b = trimmed(b);
  if (is_bare(a) && is_bare(b)) return std::ranges::equal(a, b, {}, plain_letter, plain_letter);
  return plain_name(a) == plain_name(b);
}

std::optional<std::size_t> find_field(const std::vector<std::string>& header,
                                      std::span<const std::string_view> names) {
  for (const std::string_view name : names) {
    const auto found = std::ranges::find_if(
        header, [&](const std::string& field) { return same_name(field, name); });
    if (found != header.end()) return static_cast<std::size_t>(found - header.begin());
  }
  return std::nullopt;
}

std::size_t require_field(const std::vector<std::string>& header, const std::string& name,
                          const Wording& its_setting, const std::string& file, std::size_t line) {
  const auto same = std::find(header.begin(), header.end(), name);
  if (same != header.end()) return static_cast<std::size_t>(same - header.begin());
  const std::string_view wanted = name;
  if (const auto found = find_field(header, {&wanted, 1})) return *found;
  throw Error(Message{file,
                      line,
                      its_setting + ": no field " + quoted(name, 80) + "; found " + listed(header),
                      {}});
}

std::string listed(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::string listed(const std::vector<std::string>& names) {
  return names.empty() ? "none" : names_up_to(20, names, 40);
}

void FieldTypeGuess::see(std::string_view text) {
  if (text.empty()) return;
  seen_ = true;
  if (type_ == FieldType::integer && !is_plain_integer(text)) type_ = FieldType::real;
  if (type_ == FieldType::real && !is_plain_integer(text) && !is_plain_real(text)) {
    type_ = FieldType::text;
  }
}

}  // namespace thiessen
