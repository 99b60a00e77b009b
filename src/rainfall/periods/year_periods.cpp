#include "rainfall/periods/year_periods.h"

#include "base/calendar_days.h"

namespace thiessen {

std::int64_t YearPeriods::number_of_day(std::int64_t day) const {
  return floor_quotient(month_of_day(day) + months_before(), 12);
}

std::int64_t YearPeriods::first_day(std::int64_t number) const {
  return first_day_of_month(12 * number - months_before());
}

std::string YearPeriods::name_of(std::int64_t number, std::optional<int> /*ahead_of_utc*/) const {
  return time_text(first_day_of_month(12 * number) * seconds_of_day, TimePrecision::year);
}

}  // namespace thiessen
