#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "base/iso_time.h"
#include "rainfall/periods/every.h"

namespace thiessen {

/// A calendar parts time into periods that follow each other without a gap, numbered by whole
/// numbers in their order. Each kind of period is a class.
///
/// Times are by the clock that they are written by, so that a day is the day as it is written, be
/// it of 23 hours or of 25.
class PeriodCalendar {
 public:
  virtual ~PeriodCalendar() = default;

  /// The number of the period that holds a time.
  virtual std::int64_t number_of(const IsoTime& time) const = 0;
  /// The first second of a period, from the beginning of 1970, by a clock that is so many minutes
  /// ahead of UTC. The period ends where the next one begins.
  virtual std::int64_t begin_of(std::int64_t number, int ahead_of_utc) const = 0;
  /// What a period is called: 2014-W05. `ahead_of_utc` is that of its first time, where it has one;
  /// only names with a clock show it.
  virtual std::string name_of(std::int64_t number, std::optional<int> ahead_of_utc) const = 0;
  /// How precisely the beginning of a period has to be written.
  virtual TimePrecision precision() const = 0;
};

/// The calendar of a kind of period. A storm has none: throws logic_error.
std::unique_ptr<const PeriodCalendar> calendar_of(const Every& every);

}  // namespace thiessen
