#include "readings/times/time_columns.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>

#include "base/calendar_days.h"
#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"
#include "readings/times/time_shape.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

using Part = TimeColumns::Part;

/// What columns of these names hold, by their plain names.
std::unordered_map<std::string, Part> parts_by_name() {
  std::unordered_map<std::string, Part> parts;
  const auto enter = [&](std::span<const std::string_view> names, Part part) {
    for (const std::string_view name : names) parts.emplace(plain_name(name), part);
  };
  enter(known::years, Part::year);
  enter(known::months, Part::month);
  enter(known::days, Part::day);
  enter(known::days_of_year, Part::day_of_year);
  enter(known::hours, Part::hour);
  enter(known::hours_with_minutes, Part::hour_minute);
  enter(known::minutes, Part::minute);
  enter(known::seconds, Part::second);
  return parts;
}

/// A number without a fraction of zeros, which tables get that hold gaps, too: 2010.0.
std::string_view without_zeros(std::string_view text) {
  const std::size_t point = text.find('.');
  const bool is_whole = point != std::string_view::npos && point > 0 &&
                        text.find_first_not_of('0', point + 1) == std::string_view::npos;
  return is_whole ? text.substr(0, point) : text;
}

/// A whole number of one or two digits with two; any other text as it is.
std::string with_two_digits(std::string_view text) {
  const bool one = text.size() == 1 && text[0] >= '0' && text[0] <= '9';
  return (one ? "0" : "") + std::string(text);
}

/// A month as a number, where its name is written.
std::string month_in_digits(std::string_view text) {
  const std::optional<int> month = month_called(text);
  return with_two_digits(month ? std::to_string(*month) : text);
}

/// A number with four digits, where it has fewer; any other text as it is.
std::string with_four_digits(std::string_view text) {
  const bool is_short = text.size() < 4 && parse_size(text);
  return std::string(is_short ? 4 - text.size() : 0, '0') + std::string(text);
}

/// An hour with two digits, and one with its minute, such as 100 or 2330, with four.
std::string hour_in_digits(std::string_view text) {
  return text.size() == 3 ? with_four_digits(text) : with_two_digits(text);
}

/// A second, which may have a fraction.
std::string second_in_digits(std::string_view text) {
  const std::size_t point = std::min(text.find('.'), text.size());
  return with_two_digits(text.substr(0, point)) + std::string(text.substr(point));
}

/// A part of a time as the whole text of it has it.
std::string in_digits(std::string_view text, Part part) {
  switch (part) {
    case Part::text:
      return std::string(text);
    case Part::month:
      return month_in_digits(without_zeros(text));
    case Part::day_of_year:
      return std::string(without_zeros(text));
    case Part::hour:
      return hour_in_digits(without_zeros(text));
    case Part::hour_minute:
      return with_four_digits(without_zeros(text));
    case Part::second:
      return second_in_digits(text);
    case Part::year:
    case Part::day:
    case Part::minute:
      break;
  }
  return with_two_digits(without_zeros(text));
}

/// The date of a day of a year; of one that the year lacks, or of no numbers, a text that is none.
std::string date_of(const std::string& year, const std::string& day_of_year) {
  const ParsedTime first = parse_iso_time(year);
  const Parsed<std::size_t> day = parse_size(day_of_year);
  std::string date;
  if (first && first.time.precision == TimePrecision::year && day && day.value > 0 &&
      day.value <= 366) {
    date = time_text(
        clock_seconds(first.time) + seconds_of_day * (static_cast<std::int64_t>(day.value) - 1),
        TimePrecision::day);
  }
  return date.starts_with(year) ? date : year + " day " + day_of_year;
}

/// Year, month and day put together, or year and day of the year.
std::string date_in_parts(const std::string& year, const std::string& month, const std::string& day,
                          const std::string& day_of_year) {
  if (day_of_year.empty() || (!month.empty() && !day.empty())) {
    std::string date = year;
    if (!month.empty()) date += (date.empty() ? "" : "-") + month;
    if (!day.empty()) date += (date.empty() ? "" : "-") + day;
    const bool agree = day_of_year.empty() || date_of(year, day_of_year) == date;
    return agree ? date : date + " day " + day_of_year;
  }
  return date_of(year, day_of_year);
}

}  // namespace

Part TimeColumns::part_called(std::string_view name) {
  static const std::unordered_map<std::string, Part> parts = parts_by_name();
  const auto found = parts.find(plain_name(name));
  return found == parts.end() ? Part::text : found->second;
}

bool TimeColumns::has(std::size_t field) const {
  return std::ranges::any_of(columns_, [&](const Column& one) { return one.field == field; });
}

bool TimeColumns::are_parts() const {
  return columns_.size() > 1 &&
         std::ranges::find(columns_, Part::text, &Column::part) == columns_.end();
}

std::string_view TimeColumns::text(const Row& row) {
  return columns_.size() == 1 ? row.fields[columns_[0].field] : joined(row);
}

std::string_view TimeColumns::joined(const Row& row) {
  std::array<std::string, 9> parts;
  for (const Column& column : columns_) {
    const std::string_view field = trimmed(row.fields[column.field]);
    std::string& part = parts[static_cast<std::size_t>(column.part)];
    if (field.empty()) continue;
    const bool follows = column.part == Part::text && !part.empty();
    part = (follows ? part + " " : std::string()) + in_digits(field, column.part);
  }
  const auto& [text, year, month, day, day_of_year, hour, hour_minute, minute, second] = parts;
  text_ = date_in_parts(year, month, day, day_of_year);
  if (!text.empty()) text_ += (text_.empty() ? "" : " ") + text;
  if (!hour_minute.empty()) text_ += " " + hour_minute;
  if (hour.empty()) return text_;
  text_ += " " + hour;
  if (hour.size() != 2) return text_;
  text_ += ":" + (minute.empty() ? "00" : minute);
  if (!second.empty()) text_ += ":" + second;
  return text_;
}

}  // namespace thiessen
