#include "text/unit_row.h"

#include <algorithm>
#include <cstddef>
#include <set>

#include "base/utf8.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

bool has_digit(std::string_view text) {
  return text.find_first_of("0123456789") != std::string_view::npos;
}

std::string_view without_brackets(std::string_view text) {
  const bool has_some = text.size() >= 2 && (text.front() == '(' || text.front() == '[');
  return has_some ? trimmed(text.substr(1, text.size() - 2)) : text;
}

bool is_unit(std::string_view text) {
  return std::ranges::any_of(known::units, [&](std::string_view unit) {
    return equal_ignoring_case(without_brackets(text), unit);
  });
}

}  // namespace

std::optional<UnitRow> unit_row(std::span<const std::string_view> fields) {
  if (fields.size() < 2) return std::nullopt;
  UnitRow row;
  std::set<std::string_view> units;
  row.of_column.assign(fields.size(), "");
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string_view field = fields[i];
    if (is_unit(field)) {
      row.of_column[i] = without_brackets(field);
      if (units.insert(field).second)
        row.units += (row.units.empty() ? "" : ", ") + std::string(field);
    } else if (has_digit(field)) {
      return std::nullopt;
    }
  }
  if (units.empty()) return std::nullopt;
  return row;
}

}  // namespace thiessen
