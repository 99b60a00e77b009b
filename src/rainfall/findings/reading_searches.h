#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rainfall/findings/amount_meaning.h"
#include "rainfall/findings/finding_search.h"
#include "rainfall/findings/gauge_neighbours.h"
#include "rainfall/findings/held_findings.h"
#include "rainfall/findings/neighbour_totals.h"
#include "rainfall/findings/shift_search.h"
#include "rainfall/findings/spike_search.h"
#include "rainfall/findings/stretch.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/step_intervals.h"

namespace thiessen {

/// Looks in readings that pass once for those that cannot be true beside those of the gauges next
/// to each (see FindingKind and the classes of the searches).
///
/// What is looked for depends on the length of the steps, which the first of them tell: of days and
/// shorter steps everything, but a shift of days alone; of longer ones a unit and a break. Beside
/// fewer than five gauges nothing is looked for but a stuck gauge. Memory: that of the gauges and
/// their neighbours, and 12 bytes for each year and pair of neighbours. Cost: an addition or two a
/// reading, and some 20 ns where it rains.
class ReadingSearches {
 public:
  static constexpr std::size_t least_gauges = 5;

  /// The neighbours must outlive this. `meaning` says what the readings are in.
  ReadingSearches(const GaugeNeighbours& neighbours, AmountMeaning meaning);

  /// Looks at the next step.
  void see(const TimeStep& step);
  /// Passes on what is found: what is wrong with whole gauges first, then single readings in the
  /// order of the steps. Once, after the last step.
  void conclude(const TakeFinding& take);

  /// Whether a kind is looked for; after `conclude`.
  bool is_sought(FindingKind kind) const;
  /// Why one is not.
  std::string reason_against(FindingKind kind) const;

 private:
  struct Step {
    std::string time;
    std::optional<IsoTime> moment;
    std::vector<double> readings;
  };

  void settle();
  void look_at(const std::string& time, const std::optional<IsoTime>& moment,
               std::span<const double> readings);
  void close_stretch();
  bool follows(const std::optional<IsoTime>& moment);
  bool is_fine() const;

  const GaugeNeighbours& neighbours_;
  AmountMeaning meaning_;
  StepIntervals intervals_;
  std::vector<Step> first_;  ///< those by which the length of a step is told, until it is
  bool settled_ = false;
  std::optional<StepLength> length_;
  std::optional<IsoTime> before_;  ///< the time of the last step
  bool descends_ = false;
  std::vector<StationIndex> wet_;  // of a step, at the beginning
  std::vector<StationIndex> silent_;
  Stretch stretch_;
  NeighbourTotals totals_;
  std::unique_ptr<SpikeSearch> spikes_;
  std::unique_ptr<ShiftSearch> shifts_;
  std::vector<std::unique_ptr<FindingSearch>> of_steps_;  ///< the others of single readings
  HeldFindings held_;
};

}  // namespace thiessen
