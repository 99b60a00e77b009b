#include "rainfall/periods/hour_periods.h"

#include "base/calendar_days.h"

namespace thiessen {

/// The seconds by which a clock is turned against the one by which periods are counted. Single
/// hours are counted by that of UTC, turned by no more than the minutes of the zone.
std::int64_t HourPeriods::turned_by(int ahead_of_utc) const {
  return length_ == 3'600 ? std::int64_t{60} * (ahead_of_utc - ahead_of_utc % 60) : 0;
}

std::int64_t HourPeriods::number_of(const IsoTime& time) const {
  const std::int64_t turned = turned_by(time.ahead_of_utc.value_or(0));
  return floor_quotient(clock_seconds(time) - turned - origin_, length_);
}

std::int64_t HourPeriods::begin_of(std::int64_t number, int ahead_of_utc) const {
  return origin_ + number * length_ + turned_by(ahead_of_utc);
}

std::string HourPeriods::name_of(std::int64_t number, std::optional<int> ahead_of_utc) const {
  std::string text = time_text(begin_of(number, ahead_of_utc.value_or(0)), TimePrecision::instant);
  ParsedTime begin = parse_iso_time(text);
  if (!begin) return text;  // beyond the years that are written
  begin.time.ahead_of_utc = ahead_of_utc;
  return iso_text(begin.time);
}

}  // namespace thiessen
