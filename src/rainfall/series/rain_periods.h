#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "base/error.h"
#include "base/iso_time.h"
#include "rainfall/periods/period_calendar.h"
#include "rainfall/series/held_totals.h"
#include "rainfall/series/period_sums.h"
#include "rainfall/series/rain_series.h"
#include "rainfall/series/rain_totals.h"
#include "rainfall/series/step_intervals.h"
#include "rainfall/series/step_length.h"

namespace thiessen {

/// Sums a series of areal rainfall over the periods of a calendar (PeriodCalendar). The period of a
/// step is the one that its time says as it is written: 24:00 belongs to the day that it ends, and
/// time zones play no part but where single hours are written twice. Where times end their steps,
/// the moment at which a period begins belongs to the one before it.
///
/// The steps of a period follow each other; the periods come in any order, each once. A total is
/// the sum of the steps that have a value. There is no total where no step has a value, or where
/// more steps than allowed lack one. A step that the series does not have counts as one without a
/// value: those of the period's whole length count, at the file's step (StepIntervals) and in line
/// with the period's first; a period between others that has no step at all is handed on too. Where
/// the file has no step nothing is known to lack. Sums are LongSums, so the order of the steps does
/// not matter. Memory: HeldTotals, and some 120 bytes for each period.
///
/// Where it was said when days begin, and of hours, no step may lie in two periods: that is an
/// Error if it is so of more than a tenth of them.
class RainPeriods : public RainTotals {
 public:
  /// `take` gets the periods in `finish`, for the file's step is known only then, or as they end.
  /// `file` is for messages.
  RainPeriods(Totalling totalling, std::string file, Take take);

  /// Adds a step. Throws Error if its time is not ISO 8601 or does not say its period, if its time
  /// is that of the step before written differently, and if its period has ended before.
  void add(const RainStep& step) override;
  /// Hands on all periods. Warns of steps that lack, and where it cannot be known whether some do.
  void finish(Warnings& warnings) override;

 private:
  /// A period that has steps.
  struct Held {
    std::int64_t number;  ///< by its calendar
    IsoTime first;        ///< a moment of its first step in the file
    int last_ahead;       ///< the last step's offset from UTC, in minutes
    std::size_t steps;
  };

  void require_step_of_rates(const IsoTime& time, const RainStep& step) const;
  double depth_of_rate();
  void begin(const IsoTime& time, const RainStep& step);
  void end();
  IsoTime within_step(const IsoTime& time) const;
  std::string name_of(const Held& held) const;
  std::int64_t months_within(std::int64_t number, const StepLength& step,
                             const IsoTime& in_line_with) const;
  std::int64_t expected(std::int64_t number, const StepLength& step, const IsoTime& in_line_with,
                        int growth) const;
  void hand_on_ended();
  /// How many steps a period has where none lacks, and how many lack.
  struct Extent {
    std::size_t all = 0;
    std::size_t lacking = 0;
  };
  Extent extent_of(const Held& held, const std::optional<StepLength>& step, bool ascends) const;
  bool is_left_out(const Held& last, const std::optional<StepLength>& step, const Extent& extent,
                   Warnings& warnings) const;
  bool is_in_line(const Held& held, const StepLength& step) const;
  void require_in_line(const Held& held, const std::optional<StepLength>& step);
  Error out_of_line(const Held& held, const StepLength& step) const;
  void hand_on(std::int64_t number, const IsoTime& in_line_with, std::size_t lacking,
               std::size_t expected);
  void hand_on_absent(const Held& before, const Held& after, const StepLength& step);
  void warn(Warnings& warnings) const;

  Totalling totalling_;
  std::string file_;
  Take take_;
  IsoTime before_;  ///< time of the step before
  std::string text_before_;
  std::unique_ptr<const PeriodCalendar> calendar_;
  PeriodSums sums_;
  std::unordered_set<std::int64_t> begun_;
  std::vector<Held> held_;
  HeldTotals totals_;
  StepIntervals intervals_;
  std::vector<BasinTotal> taken_;
  std::optional<StepLength> step_of_rates_;  ///< by which rates are counted, once it is known
  bool ascends_ = true;  ///< of the periods so far, where they are handed on as they end
  bool descends_ = true;
  bool ends_days_ = false;       ///< whether a time is 24:00 where times begin their steps
  std::size_t looked_at_ = 0;    ///< periods of which it is known whether a step crosses their edge
  std::size_t out_of_line_ = 0;  ///< of these, where one does
  std::size_t lacking_periods_ = 0;
  std::optional<StepLength> lacking_step_;  ///< the step that the last of them lacks
  std::string first_lacking_;
  bool open_ = false;
};

}  // namespace thiessen
