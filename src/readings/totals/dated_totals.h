#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/iso_time.h"
#include "rainfall/network/network.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/step_length.h"
#include "readings/totals/total_periods.h"
#include "readings/totals/totals_source.h"

namespace thiessen {

/// Totals of gauges that fell in one period.
struct PeriodTotals {
  struct Amount {
    StationIndex station;
    double amount;
  };

  TotalPeriod period;
  bool is_by_clock = true;  ///< the period is by the clock of the finer steps, and not of moments
  bool has_zone = false;    ///< its time has a zone
  std::string time;         ///< as it is written
  std::size_t line = 0;     ///< where the time first came
  std::vector<Amount> amounts;
};

/// What a file of totals is like, as a look through it tells.
struct TotalsSurvey {
  std::optional<StepLength> step;  ///< of the file; nothing where it has none
  bool ascends = true;             ///< times come in their order
  std::int64_t longest = 0;        ///< no period is longer, in seconds
};

/// Totals in the order in which their periods end. Memory: one step of the file.
class DatedTotals {
 public:
  /// Opens the totals. `survey` is what look_through found. A stamp that the file says itself
  /// stands in the place of the hour's. `warnings` must outlive this object.
  DatedTotals(const TotalsSource& source, ObservationHour hour, const TotalsSurvey& survey,
              Warnings& warnings);

  /// What the totals are in; empty where that is not known.
  std::string unit() const { return parts_.front().readings.amounts->unit(); }

  /// Reads the totals of the next period; returns false at the end. Throws Error as the readers do,
  /// and where a number of days is none.
  bool next(PeriodTotals& totals);
  /// How many sums of days were left out so far, for nothing tells of how many days they are.
  std::size_t without_days() const { return without_days_; }

 private:
  /// A step of one of the parts, held until its turn comes.
  struct Part {
    TotalsPart readings;
    TimeStep step;
    TimeStep days;
    IsoTime time;
    IsoTime time_of_days;
    bool has_step = false;
    bool has_days = false;
  };

  void advance(Part& part);
  Part* earliest();
  void take(Part& part);
  int days_of(Part& part, std::size_t station) const;

  std::string file_;
  std::optional<TotalPeriods> periods_;
  std::vector<Part> parts_;
  std::vector<PeriodTotals> ready_;  ///< of one step, the last to come first
  std::size_t without_days_ = 0;
};

/// Looks through totals for their step, the order of their times and their longest period. Throws
/// Error as the readers do, and where a time is none of the calendar, or a number of days none.
TotalsSurvey look_through(const TotalsSource& source);

}  // namespace thiessen
