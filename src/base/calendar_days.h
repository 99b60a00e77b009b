#pragma once

#include <cstdint>

namespace thiessen {

inline constexpr std::int64_t seconds_of_day = 86'400;

/// The quotient rounded down, so that what lies before 1970 is numbered on. `by` is above 0.
constexpr std::int64_t floor_quotient(std::int64_t number, std::int64_t by) {
  return number / by - (number % by < 0 ? 1 : 0);
}

/// The number of the month of a day, which is counted from the first of January 1970: 12 times the
/// year, and 0 for January to 11 for December.
std::int64_t month_of_day(std::int64_t day);
std::int64_t first_day_of_month(std::int64_t month);
int days_in_month(std::int64_t month);

}  // namespace thiessen
