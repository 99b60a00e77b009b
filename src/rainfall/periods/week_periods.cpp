#include "rainfall/periods/week_periods.h"

#include "base/calendar_days.h"

namespace thiessen {
namespace {

constexpr std::int64_t days = 7;
// The first of January 1970 was a Thursday, three days after its week began.
constexpr std::int64_t since_monday = 3;

}  // namespace

std::int64_t WeekPeriods::number_of_day(std::int64_t day) const {
  return floor_quotient(day + since_monday, days);
}

std::int64_t WeekPeriods::first_day(std::int64_t number) const {
  return days * number - since_monday;
}

std::string WeekPeriods::name_of(std::int64_t number, std::optional<int> /*ahead_of_utc*/) const {
  const std::int64_t thursday = first_day(number) + since_monday;
  const std::int64_t january = 12 * floor_quotient(month_of_day(thursday), 12);
  const std::int64_t week = (thursday - first_day_of_month(january)) / days + 1;
  return time_text(thursday * seconds_of_day, TimePrecision::year) + (week < 10 ? "-W0" : "-W") +
         std::to_string(week);
}

}  // namespace thiessen
