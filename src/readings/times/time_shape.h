#pragma once

#include <string>
#include <string_view>

namespace thiessen {

/// The formats (see TimeFormat) that a text of no other format fits: one, or two where its day may
/// be its month.
struct TimeShape {
  std::string format;       ///< the one format, or that with the day first; empty: none is known
  std::string month_first;  ///< that with the month first; empty where there is one
};

/// Tells the formats of a time that is written in a common way, by the look of its parts:
/// 2010/12/31, 31.12.2010, 12/31/2010, 31-Dec-2010, 01JAN2000, Dec 31, 2010, 2010123109, each with
/// a clock behind it or none (06:00, 6:00:00 PM, 0600, 2400) and a zone or none (UTC, GMT, Z,
/// +0100). Years have four digits, and where all digits stand together they begin in 1800.
TimeShape time_shape(std::string_view text);

/// Whether a text is a date with a day and without a clock, both, or a clock without a date.
bool is_date(std::string_view text);
bool is_date_with_clock(std::string_view text);
bool is_clock(std::string_view text);

}  // namespace thiessen
