#include "rainfall/periods/periods_of_days.h"

#include "base/calendar_days.h"

namespace thiessen {

std::int64_t PeriodsOfDays::number_of(const IsoTime& time) const {
  const std::int64_t clock = clock_seconds(time) - (time.hour == 24 ? 1 : 0);
  return number_of_day(floor_quotient(clock - day_start_, seconds_of_day));
}

std::int64_t PeriodsOfDays::begin_of(std::int64_t number, int /*ahead_of_utc*/) const {
  return first_day(number) * seconds_of_day + day_start_;
}

TimePrecision PeriodsOfDays::precision() const {
  return day_start_ == 0 ? precision_of_day() : TimePrecision::instant;
}

}  // namespace thiessen
