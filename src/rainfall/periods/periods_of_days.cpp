#include "rainfall/periods/periods_of_days.h"

#include <chrono>

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

std::int64_t month_of_day(std::int64_t day) {
  const std::chrono::year_month_day date{std::chrono::sys_days(std::chrono::days(day))};
  return std::int64_t{12} * static_cast<int>(date.year()) + static_cast<unsigned>(date.month()) - 1;
}

std::int64_t first_day_of_month(std::int64_t month) {
  const std::int64_t year = floor_quotient(month, 12);
  const std::chrono::sys_days day(std::chrono::year(static_cast<int>(year)) /
                                  std::chrono::month(static_cast<unsigned>(month - 12 * year + 1)) /
                                  1);
  return day.time_since_epoch().count();
}

}  // namespace thiessen
