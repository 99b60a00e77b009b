#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "rainfall/network/weights.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/step_intervals.h"
#include "rainfall/totals/surrounding_rain.h"
#include "rainfall/totals/total_spreading.h"
#include "readings/totals/dated_totals.h"
#include "readings/totals/totals_source.h"

namespace thiessen {

/// Readings of fine steps, and between them totals of other gauges, each spread over the steps of
/// its period as the gauges around it had their rain (see SurroundingRain and spread_total).
///
/// Where a gauge has both, its own readings stand in every period in which it has any, and totals
/// fill the others. A total whose period reaches beyond the fine steps is left out. Fine steps that
/// are not there at all are as those that no gauge reported. What was spread, and what was not as
/// the gauges around had it, is said in one line each when the last step has been read.
///
/// Both are read side by side, the totals once more beforehand for their step. Memory: the fine
/// steps of the longest period, and one step of totals.
class TotalledReadings : public Readings {
 public:
  /// `hour.stamp` is that of the fine steps, unless they say it themselves. `file` is what these
  /// are called in messages. The weighing and `warnings` must outlive this object.
  TotalledReadings(std::unique_ptr<Readings> fine, std::string file, TotalsSource totals,
                   const ObservationHour& hour, const Weighing& weighing, Warnings& warnings);

  /// Throws Error where a fine step has no time of the calendar or comes before its predecessor,
  /// where a total begins or ends within a fine step, where two totals of a gauge overlap, and as
  /// both readers do.
  bool next(TimeStep& step) override;
  bool is_waiting(std::chrono::milliseconds patience) override;
  std::string unit() const override { return fine_->unit(); }
  std::optional<Stamp> stamp() const override { return fine_->stamp(); }
  double share_read() const override { return fine_->share_read(); }

 private:
  /// A fine step that is held until all totals that it is part of are spread.
  struct Held {
    TimeStep step;
    std::vector<double> readings;  ///< and amounts that were spread
    std::vector<double> by_place;  ///< what gauges had: see SurroundingRain
    bool is_reported;              ///< by any gauge
    NormalMonth month;
    std::int64_t clock;   ///< seconds by its clock
    std::int64_t moment;  ///< seconds by UTC, where it has a zone
  };
  /// The steps of a period, by their places among those that are held.
  struct Steps {
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  /// Totals of one kind: how many, and the first of them.
  struct TotalsTold {
    std::size_t count = 0;
    std::string first;
    std::size_t line = 0;
  };
  /// Until when the totals of a gauge go that were read so far.
  struct Until {
    std::int64_t end;
    std::string time;
    std::size_t line;
  };

  bool is_ready() const;
  void read_on();
  void begin();
  void require_calendar(const TimeStep& step);
  void hold(const TimeStep& step);
  void spread_what_has_ended();
  void spread(const PeriodTotals& totals);
  void spread(const PeriodTotals& totals, const PeriodTotals::Amount& total, const Steps& steps);
  std::int64_t at(const Held& held, const PeriodTotals& totals) const;
  Steps steps_of(const PeriodTotals& totals) const;
  bool is_covered(const PeriodTotals& totals) const;
  void require_steps_end(const PeriodTotals& totals, std::int64_t boundary) const;
  void require_zones_alike(const PeriodTotals& totals) const;
  void check_overlap(const PeriodTotals& totals);
  void note(TotalsTold& count, const PeriodTotals& totals, const PeriodTotals::Amount& total) const;
  void require_units_alike() const;
  void conclude();
  void tell_silent() const;
  void tell(const TotalsTold& count, const std::string& what) const;

  std::unique_ptr<Readings> fine_;
  std::string file_;
  TotalsSource source_;
  ObservationHour hour_;
  const Weighing& weighing_;
  Warnings& warnings_;
  SurroundingRain surroundings_;

  TotalsSurvey survey_;
  std::optional<DatedTotals> totals_;
  PeriodTotals ahead_;  ///< the totals that are spread next
  bool has_ahead_ = false;

  std::deque<Held> held_;
  Held given_;  ///< the step that was handed out
  bool fine_ended_ = false;
  bool has_concluded_ = false;
  bool has_clock_ = true;  ///< whether the fine steps have one
  StepIntervals intervals_;
  std::optional<IsoTime> first_;
  std::optional<IsoTime> before_;  ///< the last fine step that was read
  std::string text_before_;
  std::int64_t latest_clock_ = 0;
  std::int64_t latest_moment_ = 0;

  std::vector<Until> until_;  ///< by station
  Complaints overlaps_;
  std::vector<double> around_;
  std::vector<double> amounts_;
  std::vector<StationIndex> silent_;  ///< the stations that have no reading so far
  std::vector<bool> have_totals_;     ///< by station
  std::vector<bool> with_totals_;     ///< by station: whether a total of it was spread
  TotalsTold spread_, dry_, unreported_, own_, beyond_;
};

}  // namespace thiessen
