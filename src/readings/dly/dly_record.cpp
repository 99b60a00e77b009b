#include "readings/dly/dly_record.h"

#include <algorithm>
#include <cstddef>

#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t head_columns = 21;
constexpr std::size_t value_columns = 5;
constexpr std::size_t day_columns = 8;
constexpr std::size_t quality_column = 6;
constexpr std::size_t all_columns = head_columns + 31 * day_columns;
constexpr std::size_t flags = day_columns - value_columns;

// A year outside this range is taken for a fault: rain has been measured daily since the 18th
// century.
constexpr std::size_t first_year = 1700;
constexpr std::size_t last_year = 2299;

std::string two_digits(int number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

bool is_leap(int year) {
  return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
}

std::string columns_fault(std::string_view line, bool ends) {
  const std::size_t fewest = ends ? all_columns - flags : all_columns;
  if (line.size() < fewest) {
    return "the line is cut: it has " + std::to_string(line.size()) + " of " +
           std::to_string(all_columns) + " characters";
  }
  if (line.size() > all_columns && !trimmed(line.substr(all_columns)).empty()) {
    return "the line has more than " + std::to_string(all_columns) + " characters";
  }
  return {};
}

}  // namespace

int days_in(CalendarMonth month) {
  constexpr std::array<int, 12> days = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const int of_year = number_of(month) % 12;
  return days[static_cast<std::size_t>(of_year)] +
         (of_year == 1 && is_leap(number_of(month) / 12) ? 1 : 0);
}

std::string text_of(CalendarMonth month) {
  return std::to_string(number_of(month) / 12) + "-" + two_digits(number_of(month) % 12 + 1);
}

std::string text_of(CalendarMonth month, int day) {
  return text_of(month) + "-" + two_digits(day);
}

std::optional<DlyRecord> read_dly_record(std::string_view line, bool ends, std::string& fault) {
  fault = columns_fault(line, ends);
  if (!fault.empty()) return std::nullopt;
  const std::string_view year_text = line.substr(11, 4);
  const std::string_view month_text = line.substr(15, 2);
  const Parsed<std::size_t> year = parse_size(year_text);
  const Parsed<std::size_t> month = parse_size(month_text);
  if (!year || year.value < first_year || year.value > last_year) {
    fault = "columns 12 to 15, " + quoted(year_text) + ", are no year from " +
            std::to_string(first_year) + " to " + std::to_string(last_year);
    return std::nullopt;
  }
  if (!month || month.value < 1 || month.value > 12) {
    fault = "columns 16 and 17, " + quoted(month_text) + ", are no month from 01 to 12";
    return std::nullopt;
  }
  const auto number = static_cast<std::int32_t>(12 * year.value + month.value - 1);
  return DlyRecord{line.substr(0, 11), CalendarMonth{number}, line.substr(17, 4),
                   line.substr(head_columns)};
}

DlyDay read_dly_day(const DlyRecord& record, int day) {
  const std::size_t begin = static_cast<std::size_t>(day - 1) * day_columns;
  DlyDay read;
  read.field = record.days.substr(begin, value_columns);
  std::string_view digits = read.field;
  digits.remove_prefix(std::min(digits.find_first_not_of(' '), digits.size()));
  const bool negative = digits.starts_with('-');
  if (negative) digits.remove_prefix(1);
  read.is_number = !digits.empty();
  std::int32_t value = 0;
  for (const char c : digits) {
    read.is_number = read.is_number && c >= '0' && c <= '9';
    value = value * 10 + (c - '0');
  }
  read.value = negative ? -value : value;
  const std::size_t quality = begin + quality_column;
  read.is_flagged = quality < record.days.size() && record.days[quality] != ' ';
  return read;
}

}  // namespace thiessen
