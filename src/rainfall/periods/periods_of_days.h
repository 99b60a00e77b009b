#pragma once

#include <cstdint>

#include "rainfall/periods/period_calendar.h"

namespace thiessen {

/// Periods of whole days, which begin at an hour of their own. A day is called by the date on which
/// it begins, and numbered from the first of January 1970.
class PeriodsOfDays : public PeriodCalendar {
 public:
  /// `day_start`: seconds after midnight.
  explicit PeriodsOfDays(std::int64_t day_start) : day_start_(day_start) {}

  /// 24:00 belongs to the day that it ends.
  std::int64_t number_of(const IsoTime& time) const final;
  std::int64_t begin_of(std::int64_t number, int ahead_of_utc) const final;
  TimePrecision precision() const final;

 protected:
  virtual std::int64_t number_of_day(std::int64_t day) const = 0;
  virtual std::int64_t first_day(std::int64_t number) const = 0;
  /// How precisely the first day has to be written.
  virtual TimePrecision precision_of_day() const = 0;

 private:
  std::int64_t day_start_;
};

}  // namespace thiessen
