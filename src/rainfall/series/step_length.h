#pragma once

#include <cstdint>
#include <string>

#include "base/calendar_days.h"
#include "base/iso_time.h"

namespace thiessen {

/// The length of the steps of a file: months of the calendar, or seconds by the clock. One of the
/// two is 0.
struct StepLength {
  std::int64_t months = 0;
  std::int64_t seconds = 0;

  bool is_a_day_or_less() const { return months == 0 && seconds <= seconds_of_day; }
  friend bool operator==(const StepLength& a, const StepLength& b) = default;
};

/// Words a length for a message: `1 year`, `3 months`, `1 day`, `6 hours`, `10 minutes`.
std::string text_of(const StepLength& length);

/// The number of a month: 12 times the year, and 0 for January to 11 for December.
constexpr std::int64_t month_number(const IsoTime& time) {
  return std::int64_t{12} * time.year + time.month - 1;
}

bool is_last_of_month(const IsoTime& time);
/// So many months later on the same day, or on the last day where the month has no such day and
/// where it was the last before.
IsoTime months_later(const IsoTime& time, std::int64_t months);

/// Whether a time stands where the other does within its month: at the same day and clock, or both
/// on the last day.
bool stand_alike_in_months(const IsoTime& a, const IsoTime& b);

}  // namespace thiessen
