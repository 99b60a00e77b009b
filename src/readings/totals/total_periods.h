#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/iso_time.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/step_length.h"

namespace thiessen {

/// When totals are read, as the user says it and as the file of finer steps has it.
struct ObservationHour {
  /// Minutes after midnight, to 1440 for its end; nothing where it is not said.
  std::optional<int> minutes;
  /// A date is that of the day on which the rain began, and the total is read on the day after.
  bool is_dated_before = false;
  /// Whether a total with a clock begins or ends at it.
  Stamp stamp = Stamp::begin;
};

/// The time in which a total fell, from `begin` up to `end`: in seconds from the beginning of 1970,
/// by UTC where the total's time has a zone, else by the clock.
struct TotalPeriod {
  std::int64_t begin = 0;
  std::int64_t end = 0;

  friend bool operator==(const TotalPeriod& a, const TotalPeriod& b) = default;
};

/// The period of a total of one step of its file, or of so many days: see period_of.
///
/// A total that is dated D, with no clock, ends at the hour of observation of D, or of the day
/// after; a month or year ends so on its last day. With a clock it begins or ends at its time as
/// the stamp says; where an hour of observation is said, a clock of 00:00 is none, as databases
/// write dates so. A total of several days ends where one of a single step would.
class TotalPeriods {
 public:
  /// `step`: that of the file of totals, nothing where it has none; dates are then of a day each.
  TotalPeriods(ObservationHour hour, std::optional<StepLength> step) : hour_(hour), step_(step) {}

  /// The period of a total that is dated `time`; `days` is 0 for one of the file's step. Throws
  /// Error, naming the file and line, where the time does not tell it: it has no hour and none is
  /// said, it has one beside that which is said, or nothing tells how long it is.
  TotalPeriod of(const IsoTime& time, int days, const std::string& text, const std::string& file,
                 std::size_t line) const;
  /// Whether times like this one count by the clock, and not as moments.
  bool is_by_clock(const IsoTime& time) const;

 private:
  TotalPeriod of_date(const IsoTime& time, int days, int minutes) const;
  TotalPeriod of_moment(const IsoTime& time, int days, const StepLength& step) const;

  ObservationHour hour_;
  std::optional<StepLength> step_;
};

}  // namespace thiessen
