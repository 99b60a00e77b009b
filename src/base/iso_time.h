#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace thiessen {

/// How much of a time is written.
enum class TimePrecision : std::uint8_t { year, month, day, instant };

/// A time of ISO 8601, by the calendar and the clock of whoever wrote it. What is not written is
/// its beginning: the first month, the first day, midnight.
struct IsoTime {
  TimePrecision precision = TimePrecision::year;
  int year = 0;
  int month = 1;
  int day = 1;
  int hour = 0;  ///< 24 at the end of the day
  int minute = 0;
  int second = 0;
  int nanosecond = 0;
  std::optional<int> ahead_of_utc;  ///< in minutes, where a zone is written
};

enum class IsoTimeFault : std::uint8_t {
  none,
  form,   ///< not written as ISO 8601 wants it
  value,  ///< a month, day, hour, minute or second that there is not
};

struct ParsedTime {
  IsoTime time = {};
  IsoTimeFault fault = IsoTimeFault::form;

  explicit operator bool() const { return fault == IsoTimeFault::none; }
};

/// What is read as a time, for messages.
inline constexpr const char* iso_time_forms =
    "2013, 2013-08, 2013-08-31, 2013-08-31T06:00 or 20130831T0600";

/// Reads YYYY, YYYY-MM, YYYY-MM-DD or YYYYMMDD; after a day also T or one blank and hh, hh:mm,
/// hh:mm:ss or hh:mm:ss.f (1 to 9 digits), without colons where the day has no hyphens; after that
/// also Z, +hh, +hh:mm or +hhmm. 24:00 is the end of the day that is written. YYYYMM is refused:
/// ISO 8601 does, for it might be YYMMDD. Leap seconds are refused.
ParsedTime parse_iso_time(std::string_view text);

/// The order of two moments: where both have a zone that of the moments themselves, else that of
/// what the clocks say. 24:00 is 0:00 of the next day.
std::strong_ordering order_of_moments(const IsoTime& a, const IsoTime& b);

/// The order of the years, months or days in which two times are written.
std::strong_ordering order_of_dates(const IsoTime& a, const IsoTime& b, TimePrecision precision);

/// The year, month or day in which a time is written: 2013, 2013-08, 2013-08-01.
std::string date_text(const IsoTime& time, TimePrecision precision);

}  // namespace thiessen
