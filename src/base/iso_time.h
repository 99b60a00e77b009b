#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace thiessen {

/// How precisely a time is written.
enum class TimePrecision : std::uint8_t { year, month, day, instant };

/// A time as ISO 8601 writes it, by the calendar and the clock of whoever wrote it. A part that is
/// not written has its first value: the first month, the first day, midnight.
struct IsoTime {
  TimePrecision precision = TimePrecision::year;
  int year = 0;
  int month = 1;
  int day = 1;
  int hour = 0;  ///< 0 to 24, which is the end of the day
  int minute = 0;
  int second = 0;
  int nanosecond = 0;
  std::optional<int> ahead_of_utc;  ///< the zone's offset in minutes, where a zone is written
};

/// Why a text is not read as a time.
enum class IsoTimeFault : std::uint8_t {
  none,
  form,   ///< not written as ISO 8601 wants it
  value,  ///< a month, day, hour, minute or second that does not exist
};

/// A time that was read, or the reason why there is none.
struct ParsedTime {
  IsoTime time = {};
  IsoTimeFault fault = IsoTimeFault::form;

  explicit operator bool() const { return fault == IsoTimeFault::none; }
};

/// The forms that are read as a time, for messages.
inline constexpr const char* iso_time_forms =
    "2013, 2013-08, 2013-08-31, 2013-08-31T06:00 or 20130831T0600";

/// Reads a time of ISO 8601. The forms are YYYY, YYYY-MM, YYYY-MM-DD and YYYYMMDD. After a day
/// there may be T or one blank and hh, hh:mm, hh:mm:ss or hh:mm:ss.f (1 to 9 digits), without
/// colons where the day has no hyphens; and after that Z, +hh, +hh:mm or +hhmm. 24:00 is the end of
/// the day that is written. YYYYMM is refused, as by ISO 8601, because it might be YYMMDD. Leap
/// seconds are refused.
ParsedTime parse_iso_time(std::string_view text);

/// The seconds from the beginning of 1970 to a time, by the clock that it is written by. Fractions
/// are left out.
std::int64_t clock_seconds(const IsoTime& time);

/// The seconds from the beginning of 1970 to a time: of UTC where a zone is written, else by its
/// own clock.
std::int64_t moment_seconds(const IsoTime& time);

/// The text of the moment so many seconds after the beginning of 1970: a date for
/// TimePrecision::day and coarser ones, else YYYY-MM-DDThh:mm, with seconds where there are any. A
/// zone may bring it a day beyond the years that ISO 8601 writes: -0001-12-31, 10000-01-01.
std::string time_text(std::int64_t seconds, TimePrecision precision);

/// A time as ISO 8601 writes it, in its own precision: 2013-08-31, 2013-08-31T06:00:00.5+01:00.
std::string iso_text(const IsoTime& time);

/// The order of two moments. Where both have a zone the moments themselves are compared, otherwise
/// what the clocks say. 24:00 is 0:00 of the next day.
std::strong_ordering order_of_moments(const IsoTime& a, const IsoTime& b);

/// The order of the years, months or days in which two times are written.
std::strong_ordering order_of_dates(const IsoTime& a, const IsoTime& b, TimePrecision precision);

/// The text of the year, month or day in which a time is written: 2013, 2013-08, 2013-08-01.
std::string date_text(const IsoTime& time, TimePrecision precision);

}  // namespace thiessen
