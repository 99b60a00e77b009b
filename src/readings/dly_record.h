#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace thiessen {

/// A month of the Gregorian calendar: 12 times the year, and 0 for January to 11.
enum class CalendarMonth : std::int32_t {};

constexpr std::int32_t number_of(CalendarMonth month) {
  return static_cast<std::int32_t>(month);
}
int days_in(CalendarMonth month);
/// YYYY-MM, and YYYY-MM-DD with a day from 1.
std::string text_of(CalendarMonth month);
std::string text_of(CalendarMonth month, int day);

/// A line of a `.dly` file of NOAA's GHCN-Daily: the days of a month of one element of one station.
/// Columns from 1: id 1-11, year 12-15, month 16-17, element 18-21, then for each of 31 days its
/// value in 5 columns, a measurement flag, a quality flag and a source flag (see the readme.txt of
/// the data set, section III).
struct DlyRecord {
  std::string_view id;
  CalendarMonth month = {};
  std::string_view element;
  std::string_view days;  ///< the columns after these
};

/// Reads the columns up to the days. `ends`: whether a line end follows; blanks at the end of such
/// a line may be missing. Else says in `fault` what is wrong.
std::optional<DlyRecord> read_dly_record(std::string_view line, bool ends, std::string& fault);

constexpr std::int32_t dly_missing = -9999;

/// What a day's columns say.
struct DlyDay {
  std::string_view field;            ///< the value's columns
  std::int32_t value = dly_missing;  ///< rain: tenths of a millimetre
  bool is_number = false;
  bool is_flagged = false;  ///< failed a check of quality
};

/// `day` from 1 to 31.
DlyDay read_dly_day(const DlyRecord& record, int day);

}  // namespace thiessen
