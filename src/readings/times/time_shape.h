#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace thiessen {

/// The formats (see TimeFormat) that a text of no other format fits: one, or two where its day may
/// be its month.
struct TimeShape {
  std::string format;       ///< the one format, or that with the day first; empty: none is known
  std::string month_first;  ///< that with the month first; empty where there is one
};

/// Tells the formats of a time that is written in a common way, by the look of its parts:
/// 2010/12/31, 31.12.2010, 12/31/2010, 31-Dec-2010, 01JAN2000, Dec 31, 2010, 2010123109, the day of
/// a year 2010-365, each with a clock behind it or none (06:00, 6:00:00 PM, 0600, 2400) and a zone
/// or none (UTC, GMT, Z, +0100); and the months 2010/12, 12/2010, Dec 2010, 2010 December. Years
/// have four digits, and where all digits stand together they begin in 1800.
TimeShape time_shape(std::string_view text);

/// The formats in which a text can be read that leaves something open, and so is no time by
/// itself: the century of a year of two digits (31/12/99, 31-Dec-99, 991231), a year and month or a
/// date (201001), a day of a year or a mere number (2010365), the serial number of a spreadsheet
/// (42370). None where it is no such text.
std::vector<std::string> open_formats(std::string_view text);

/// The number of a month by its English name or the first three letters of that.
std::optional<int> month_called(std::string_view name);

/// Whether a text is a date with a day and without a clock, both, or a clock without a date.
bool is_date(std::string_view text);
bool is_date_with_clock(std::string_view text);
bool is_clock(std::string_view text);

}  // namespace thiessen
