#include "rainfall/periods/month_periods.h"

#include "base/calendar_days.h"

namespace thiessen {

std::int64_t MonthPeriods::number_of_day(std::int64_t day) const {
  return month_of_day(day);
}

std::int64_t MonthPeriods::first_day(std::int64_t number) const {
  return first_day_of_month(number);
}

std::string MonthPeriods::name_of(std::int64_t number, std::optional<int> /*ahead_of_utc*/) const {
  return time_text(first_day(number) * seconds_of_day, TimePrecision::month);
}

}  // namespace thiessen
