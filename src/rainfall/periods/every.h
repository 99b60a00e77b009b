#pragma once

#include <cstdint>

#include "base/iso_time.h"

namespace thiessen {

/// The kinds of periods over which steps are summed.
enum class PeriodUnit : std::uint8_t { hours, day, week, month, season, year, storm };

/// The periods over which steps are summed. All but hours are made of days, which begin at the
/// hour `day_start`; a storm lies between spells in which it is dry everywhere.
struct Every {
  Every(PeriodUnit unit) : unit(unit) {}  // NOLINT(google-explicit-constructor)

  PeriodUnit unit;
  int hours = 1;               ///< how many a period of hours has
  std::int64_t day_start = 0;  ///< seconds after midnight
  /// Whether it was said when days begin, so that a step may not lie on both sides.
  bool has_day_start = false;
  int year_start = 1;  ///< the month with which a year begins, from 1
  /// The day since 1970 from which hours are counted of which no whole number makes a day.
  std::int64_t first_day = 0;
  std::int64_t dry = 21'600;  ///< the seconds of a dry spell that ends a storm

  /// How precisely the times of steps have to be written.
  TimePrecision least_precision() const;
};

}  // namespace thiessen
