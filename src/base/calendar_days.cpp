#include "base/calendar_days.h"

#include <chrono>

namespace thiessen {

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

int days_in_month(std::int64_t month) {
  return static_cast<int>(first_day_of_month(month + 1) - first_day_of_month(month));
}

}  // namespace thiessen
