#include "text/field_names.h"

#include <algorithm>

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

}  // namespace

std::optional<std::size_t> find_field(const std::vector<std::string>& header,
                                      std::span<const std::string_view> names) {
  for (const std::string_view name : names) {
    const auto found = std::find_if(header.begin(), header.end(), [&](const std::string& field) {
      return equal_ignoring_case(field, name);
    });
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
  constexpr std::size_t at_most = 20;
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < at_most; ++i) {
    text += (i == 0 ? "" : ", ") + quoted(names[i], 40);
  }
  if (names.empty()) return "none";
  return names.size() <= at_most
             ? text
             : text + " and " + std::to_string(names.size() - at_most) + " more";
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
