#include "rainfall/periods/day_periods.h"

#include "base/calendar_days.h"

namespace thiessen {

std::int64_t DayPeriods::number_of_day(std::int64_t day) const {
  return day;
}

std::int64_t DayPeriods::first_day(std::int64_t number) const {
  return number;
}

std::string DayPeriods::name_of(std::int64_t number, std::optional<int> /*ahead_of_utc*/) const {
  return time_text(number * seconds_of_day, TimePrecision::day);
}

}  // namespace thiessen
