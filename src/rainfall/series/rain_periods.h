#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "base/error.h"
#include "base/iso_time.h"
#include "geometry/long_sum.h"
#include "rainfall/errors/total_error.h"
#include "rainfall/series/held_totals.h"
#include "rainfall/series/rain_series.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/step_depths.h"
#include "rainfall/series/step_intervals.h"
#include "rainfall/series/time_range.h"

namespace thiessen {

/// The totals of one year, month or day of a series of areal rainfall.
struct RainPeriod {
  std::string time;  ///< such as 2013, 2013-08 or 2013-08-01
  std::vector<BasinTotal> basins;
};

/// The periods over which rainfall is summed, and how many values a total may lack.
struct Totalling {
  TimePrecision every = TimePrecision::month;  ///< not instant
  std::size_t allowed_missing = 0;  ///< steps that may lack a value in a period with a total
  TimeRange range = {};             ///< the steps that count; what lies beyond does not lack
  Stamp stamp = Stamp::begin;       ///< what the times of the steps are
  /// Whether a period is handed on as soon as a step of another comes. What it lacks is then told
  /// by the file's step as far as that is known by then.
  bool as_they_end = false;
  /// Whether the last period is left out where its end is not known: it lacks steps, or the file
  /// has no step.
  bool whole_alone = false;
  /// What values count for that are rates; nothing where they are depths.
  std::optional<StepDepths> depths = {};
  /// The same of rates whose step their own times tell by the end of the first period. A later time
  /// that is not whole steps from the one before is an Error.
  std::optional<RatesOfUnknownStep> rates = {};
  /// How the errors of steps go together, where totals are to have errors; else null.
  std::shared_ptr<const ErrorCorrelation> errors = {};
};

/// Sums a series of areal rainfall over calendar periods. The period of a step is the one that its
/// time says as it is written: 24:00 belongs to the day that it ends, and time zones play no part.
/// Where times end their steps, midnight belongs to the day, month or year before it.
///
/// The steps of a period follow each other; the periods come in any order, each once. A total is
/// the sum of the steps that have a value. There is no total where no step has a value, or where
/// more steps than allowed lack one. A step that the series does not have counts as one without a
/// value: those of the period's whole length count, at the file's step (StepIntervals) and in line
/// with the period's first; a period between others that has no step at all is handed on too. Where
/// the file has no step nothing is known to lack. Sums are LongSums, so the order of the steps does
/// not matter. Memory: HeldTotals, and some 120 bytes for each period.
class RainPeriods {
 public:
  using Take = std::function<void(const RainPeriod&)>;

  /// `take` gets the periods in `finish`, for the file's step is known only then, or as they end.
  /// `file` is for messages.
  RainPeriods(Totalling totalling, std::string file, Take take);

  /// Adds a step. Throws Error if its time is not ISO 8601 or does not say its period, if its time
  /// is that of the step before written differently, and if its period has ended before.
  void add(const RainStep& step);
  /// Hands on all periods. Warns of steps that lack, and where it cannot be known whether some do.
  void finish(Warnings& warnings);

 private:
  struct Sum {
    LongSum rainfall;
    std::size_t values = 0;
    std::size_t missing = 0;
  };
  /// A period that has steps.
  struct Held {
    std::int64_t number;  ///< of the year, of the month (month_number) or of the day since 1970
    IsoTime first;        ///< the time of its first step in the file
    int last_ahead;       ///< the last step's offset from UTC, in minutes
    std::size_t steps;
  };

  void require_step_of_rates(const IsoTime& time, const RainStep& step) const;
  double depth_of_rate();
  void begin(const IsoTime& time, const RainStep& step);
  void end();
  IsoTime within_step(const IsoTime& time) const;
  std::int64_t number_of(const IsoTime& time) const;
  std::string text_of(std::int64_t number) const;
  std::int64_t begin_of(std::int64_t number) const;
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
  void hand_on(std::int64_t number, std::size_t lacking, std::size_t expected);
  void hand_on_absent(const Held& before, const Held& after, const StepLength& step);
  void warn(Warnings& warnings) const;

  Totalling totalling_;
  std::string file_;
  Take take_;
  IsoTime before_;  ///< time of the step before
  std::string text_before_;
  std::vector<Sum> sums_;
  TotalErrors errors_;
  std::unordered_set<std::int64_t> begun_;
  std::vector<Held> held_;
  HeldTotals totals_;
  StepIntervals intervals_;
  std::vector<BasinTotal> taken_;
  std::optional<StepLength> step_of_rates_;  ///< by which rates are counted, once it is known
  bool ascends_ = true;  ///< of the periods so far, where they are handed on as they end
  bool descends_ = true;
  bool ends_days_ = false;  ///< whether a time is 24:00 where times begin their steps
  std::size_t lacking_periods_ = 0;
  std::optional<StepLength> lacking_step_;  ///< the step that the last of them lacks
  std::string first_lacking_;
  bool open_ = false;
};

}  // namespace thiessen
