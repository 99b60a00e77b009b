#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/iso_time.h"
#include "rainfall/errors/error_correlation.h"
#include "rainfall/periods/every.h"
#include "rainfall/series/held_totals.h"
#include "rainfall/series/rain_series.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/step_depths.h"
#include "rainfall/series/step_length.h"
#include "rainfall/series/time_range.h"

namespace thiessen {

/// The totals of one period of a series of areal rainfall.
struct RainPeriod {
  std::string time;  ///< such as 2013, 2013-08, 2013-W35 or 2013-08-01T06:00
  std::vector<BasinTotal> basins;
  /// When it begins, as precisely as its beginning has to be written; of a storm the time of its
  /// first wet step. Without a zone where its name has none.
  ParsedTime begin = {};
  std::string last = {};  ///< the time of the last wet step of a storm; else empty
};

/// The periods over which rainfall is summed, and how many values a total may lack.
struct Totalling {
  Every every = PeriodUnit::month;
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
  /// The step of the file where it is known beforehand, as storms want it: else they take the one
  /// that the times so far tell.
  std::optional<StepLength> step = {};
  /// How the errors of steps go together, where totals are to have errors; else null.
  std::shared_ptr<const ErrorCorrelation> errors = {};
};

/// The length of a period; nothing where they are of storms, each of which has its own.
std::optional<StepLength> length_of(const Every& every);

/// Sums a series of areal rainfall over periods.
class RainTotals {
 public:
  using Take = std::function<void(const RainPeriod&)>;

  virtual ~RainTotals() = default;
  /// Adds a step. Throws Error where its time is not of the calendar, or does not say its period.
  virtual void add(const RainStep& step) = 0;
  /// Hands on the periods that are still held. Warns of steps that lack, and where it cannot be
  /// known whether some do.
  virtual void finish(Warnings& warnings) = 0;
};

/// The totals over the periods that are wanted: RainPeriods or RainStorms, whose headers say what
/// they hand on. `take` gets each period, and `file` is for messages.
std::unique_ptr<RainTotals> totals_of(Totalling totalling, std::string file, RainTotals::Take take);

}  // namespace thiessen
