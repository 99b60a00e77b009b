#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/iso_time.h"
#include "rainfall/periods/period_calendar.h"

namespace thiessen {

/// What the period of a time is called.
inline std::string period_of(const PeriodCalendar& calendar, const std::string& time) {
  const IsoTime parsed = parse_iso_time(time).time;
  return calendar.name_of(calendar.number_of(parsed), parsed.ahead_of_utc);
}

/// When the period of a time begins, by the clock of that time.
inline std::string begin_of(const PeriodCalendar& calendar, const std::string& time) {
  const IsoTime parsed = parse_iso_time(time).time;
  return time_text(calendar.begin_of(calendar.number_of(parsed), parsed.ahead_of_utc.value_or(0)),
                   calendar.precision());
}

/// The first period, from one time to another, that does not follow the one before it, or which a
/// moment before its beginning or at its beginning is not counted in; empty where all do.
inline std::string first_gap(const PeriodCalendar& calendar, const std::string& from,
                             const std::string& to) {
  const std::int64_t last = calendar.number_of(parse_iso_time(to).time);
  for (std::int64_t number = calendar.number_of(parse_iso_time(from).time); number <= last;
       ++number) {
    const std::int64_t begin = calendar.begin_of(number, 0);
    const auto number_at = [&](std::int64_t second) {
      return calendar.number_of(parse_iso_time(time_text(second, TimePrecision::instant)).time);
    };
    if (number_at(begin) != number || number_at(begin - 1) != number - 1)
      return calendar.name_of(number, std::nullopt);
  }
  return "";
}

}  // namespace thiessen
