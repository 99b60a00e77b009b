#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace thiessen {

/// A month of the Gregorian calendar, as a number: 12 times the year, plus 0 for January to 11 for
/// December.
enum class CalendarMonth : std::int32_t {};

constexpr std::int32_t number_of(CalendarMonth month) {
  return static_cast<std::int32_t>(month);
}
int days_in(CalendarMonth month);
/// Writes a month as YYYY-MM, and a day (from 1) as YYYY-MM-DD.
std::string text_of(CalendarMonth month);
std::string text_of(CalendarMonth month, int day);

/// A line of a `.dly` file of NOAA's GHCN-Daily: the days of one month of one element at one
/// station.
///
/// The columns, from 1: id 1-11, year 12-15, month 16-17, element 18-21. Then each of 31 days has a
/// value in 5 columns, a measurement flag, a quality flag and a source flag. Source: the data set's
/// readme.txt, section III.
struct DlyRecord {
  std::string_view id;
  CalendarMonth month = {};
  std::string_view element;
  std::string_view days;  ///< the columns after these
};

/// Reads the columns up to the days. If the line is wrong, `fault` says why and nothing is
/// returned. `ends` tells whether a line end follows; only then may blanks at the end of the line
/// be missing.
std::optional<DlyRecord> read_dly_record(std::string_view line, bool ends, std::string& fault);

constexpr std::int32_t dly_missing = -9999;

/// What the columns of a day say.
struct DlyDay {
  std::string_view field;            ///< the value's columns
  std::int32_t value = dly_missing;  ///< of rain: in tenths of a millimetre
  bool is_number = false;
  bool is_flagged = false;  ///< whether it failed a check of quality
};

/// Reads the columns of a day, from 1 to 31.
DlyDay read_dly_day(const DlyRecord& record, int day);

}  // namespace thiessen
