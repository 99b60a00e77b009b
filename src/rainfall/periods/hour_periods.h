#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/calendar_days.h"
#include "rainfall/periods/period_calendar.h"

namespace thiessen {

/// Periods of so many hours, counted from the hour at which days begin, and called by the time at
/// which they begin: 2014-02-01T06:00, with the zone where times have one.
///
/// Where a whole number of them makes a day, every day has the same. Else they are counted on
/// through the days from a first one. Hours are those of the clock as it is written: where it is
/// put back, the period that holds the change is longer by what the clock shows twice. Only of
/// single hours those that are written twice are two, told apart by their zones.
class HourPeriods : public PeriodCalendar {
 public:
  /// `hours` above 0. `day_start`: seconds after midnight. `first_day`: days since 1970.
  HourPeriods(int hours, std::int64_t day_start, std::int64_t first_day)
      : length_(std::int64_t{3'600} * hours), origin_(first_day * seconds_of_day + day_start) {}

  std::int64_t number_of(const IsoTime& time) const override;
  std::int64_t begin_of(std::int64_t number, int ahead_of_utc) const override;
  std::string name_of(std::int64_t number, std::optional<int> ahead_of_utc) const override;
  TimePrecision precision() const override { return TimePrecision::instant; }

 private:
  std::int64_t turned_by(int ahead_of_utc) const;

  std::int64_t length_;  ///< seconds
  std::int64_t origin_;  ///< where the period with the number 0 begins, by the clock
};

}  // namespace thiessen
