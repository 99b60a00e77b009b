#include "readings/times/time_columns.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/utf8.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

using Part = TimeColumns::Part;

bool is_called(std::string_view name, std::span<const std::string_view> names) {
  return std::ranges::any_of(names, [&](std::string_view one) { return same_name(name, one); });
}

/// A whole number of one or two digits with two; any other text as it is.
std::string with_two_digits(std::string_view text) {
  const bool one = text.size() == 1 && text[0] >= '0' && text[0] <= '9';
  return (one ? "0" : "") + std::string(text);
}

}  // namespace

Part TimeColumns::part_called(std::string_view name) {
  if (is_called(name, known::years)) return Part::year;
  if (is_called(name, known::months)) return Part::month;
  if (is_called(name, known::days)) return Part::day;
  if (is_called(name, known::hours)) return Part::hour;
  if (is_called(name, known::minutes)) return Part::minute;
  return Part::text;
}

bool TimeColumns::has(std::size_t field) const {
  return std::ranges::any_of(columns_, [&](const Column& one) { return one.field == field; });
}

std::string_view TimeColumns::text(const Row& row) {
  return columns_.size() == 1 ? row.fields[columns_[0].field] : joined(row);
}

std::string_view TimeColumns::joined(const Row& row) {
  std::array<std::string, 6> parts;
  text_.clear();
  for (const Column& column : columns_) {
    const std::string_view field = trimmed(row.fields[column.field]);
    std::string& part = parts[static_cast<std::size_t>(column.part)];
    if (field.empty()) continue;
    if (column.part == Part::text) {
      part += (part.empty() ? "" : " ") + std::string(field);
    } else {
      part = with_two_digits(field);
    }
  }
  const auto& [text, year, month, day, hour, minute] = parts;
  text_ = year;
  if (!month.empty()) text_ += (text_.empty() ? "" : "-") + month;
  if (!day.empty()) text_ += (text_.empty() ? "" : "-") + day;
  if (!text.empty()) text_ += (text_.empty() ? "" : " ") + text;
  if (hour.empty()) return text_;
  text_ += " " + hour;
  if (hour.size() == 2) text_ += ":" + (minute.empty() ? "00" : minute);
  return text_;
}

}  // namespace thiessen
