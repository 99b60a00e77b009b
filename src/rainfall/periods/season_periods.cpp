#include "rainfall/periods/season_periods.h"

#include <array>
#include <cstddef>

#include "base/calendar_days.h"

namespace thiessen {
namespace {

constexpr std::array<const char*, 4> names{"-DJF", "-MAM", "-JJA", "-SON"};

}  // namespace

std::int64_t SeasonPeriods::number_of_day(std::int64_t day) const {
  return floor_quotient(month_of_day(day) + 1, 3);  // December is the first month of the next year
}

std::int64_t SeasonPeriods::first_day(std::int64_t number) const {
  return first_day_of_month(3 * number - 1);
}

std::string SeasonPeriods::name_of(std::int64_t number, std::optional<int> /*ahead_of_utc*/) const {
  const std::int64_t year = floor_quotient(number, 4);
  return time_text(first_day_of_month(12 * year) * seconds_of_day, TimePrecision::year) +
         names[static_cast<std::size_t>(number - 4 * year)];
}

}  // namespace thiessen
