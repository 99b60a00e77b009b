#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/iso_time.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/step_intervals.h"
#include "rainfall/series/step_length.h"

namespace thiessen {

/// The time of a step by the calendar, for a file whose format has a `name`. Throws Error, with the
/// file and line of the readings, where it is a label or may be read in two ways.
IsoTime calendar_time_for(const std::string& name, std::string_view time,
                          const std::optional<WrittenTime>& written, const std::string& file,
                          std::size_t line);

/// The times of a series, seen one after the other. Memory: StepIntervals.
class SeriesTimes {
 public:
  /// `file` is that of the readings, and `format` the name of what is written, for messages.
  /// `step` is that of the series where it is known beforehand.
  SeriesTimes(std::string file, std::string format, std::optional<StepLength> step = {})
      : file_(std::move(file)), format_(std::move(format)), known_step_(step) {}

  /// Takes note of the next time. Throws Error where it has a zone and others have none.
  void note(const IsoTime& time);
  std::size_t count() const { return count_; }
  const IsoTime& first() const { return first_; }
  /// The zone by whose clock seconds are told: that of the first time.
  std::optional<int> zone() const { return first_.ahead_of_utc; }
  /// The seconds from the beginning of 1970 to a time, by the clock of `zone` where there is one,
  /// else by its own. Fractions are left out.
  std::int64_t seconds_of(const IsoTime& time) const;
  /// The step of the series; of a single time the day, month or year that it names.
  std::optional<StepLength> step() const;

 private:
  std::string file_;
  std::string format_;
  std::optional<StepLength> known_step_;
  IsoTime first_;
  std::size_t count_ = 0;
  StepIntervals intervals_;
};

/// The zone as ISO 8601 writes it: `Z` or `+05:30`.
std::string zone_text(int minutes_ahead);

}  // namespace thiessen
