#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "rainfall/gaps/departures.h"
#include "rainfall/gaps/handover.h"
#include "rainfall/gaps/handover_cache.h"
#include "rainfall/gaps/nearest_sets.h"
#include "rainfall/influence/cell_readings.h"

namespace thiessen {

/// What a gauge is worth to a basin: how much the areal rainfall changes when it is left out.
struct GaugeInfluence {
  StationIndex station;
  double weight;       ///< in the full network; 0: it weighs only where others are silent
  double rms_change;   ///< root mean square of the changes, in the readings' unit; NaN: no value is
                       ///< left without it in any step
  double mean_change;  ///< their mean: above 0 where the values without it are higher
};

/// How much a basin's areal rainfall changes over a series of steps when a gauge is left out.
///
/// The change of a step is the value without the gauge's reading less the value with it. Both are
/// of the tessellation of the gauges that report (Retessellation), so the change is that of one
/// deletion, taken back. All steps count at which both values exist: where the gauge itself is
/// silent the change is 0, and where it alone reports there is none.
///
/// The same comes out if the series is compared with one computed from a file without the gauge's
/// column. In a plane the two agree to 1e-12 of the largest reading. On the Earth they agree as far
/// as the values of silent gauges are accurate (2e-11 in Colorado, 1e-7 where gauges are 100 km
/// apart), for without the gauge's column ground that it has no part in is handed over in another
/// chart.
///
/// When a gauge is left out its cell falls silent, and its ground goes to the cells that border it
/// (see Departures). The change is the sum of weight x (the new owner's reading - the gauge's own).
/// Where all neighbours report, a step costs one multiplication for each of them and each basin.
/// Where some are silent, who gets the ground is looked up, and computed if it is not remembered.
/// With normals, and where two cells at most are silent beside it, that is what the cell and the
/// silent components beside it hand over as one component, less what these did. If several stations
/// report in a cell, leaving one out moves the cell's mean and nothing else. So the change is 0
/// where all readings are the same.
///
/// The sums of a cell are formed in the order of the steps, or month by month within a block where
/// months have normals of their own, so they do not depend on the threads.
/// Memory: the block of steps, and 48 bytes for each basin and gauge that weighs in it.
class Influence {
 public:
  /// The handovers must outlive this object.
  /// `remembered_bytes` bounds the handovers that are remembered.
  Influence(const Handovers& handovers, std::size_t remembered_bytes, unsigned threads);

  /// Takes the next steps of the series. Where there are normals the year's count or, where
  /// `months` has a calendar month for each step, those of its month.
  void add(StepRows rows, std::span<const std::size_t> months = {});

  /// The influences by basin, in the order of the stations. They are those of stations that weigh
  /// in the basin in the full network or in a step that counts.
  std::vector<std::vector<GaugeInfluence>> result() const;

 private:
  /// The sums of a station's changes. Long doubles have a range that no square leaves.
  struct Sums {
    long double changes = 0;
    long double squares = 0;
    bool weighs = false;  ///< whether it weighs in the full network or a step that counts

    void add(double change) {
      weighs = true;
      changes += change;
      squares += static_cast<long double>(change) * change;
    }
  };
  /// The part of a cell in one basin, over all steps.
  struct Part {
    std::uint32_t basin;
    /// In the full network, by month of the normals: weight x normal, and the weight without any.
    std::vector<double> weights;
    std::vector<Sums> sums;  ///< by station of the cell
  };
  struct Cell {
    std::vector<Part> parts;                   ///< by basin
    std::shared_ptr<const Handover> handover;  ///< when the cell alone falls silent
  };
  /// The part of a cell in one basin at one step.
  struct Moment {
    std::uint32_t basin;
    double weight;
    double change;  ///< of the basin's value if the cell falls silent
  };
  /// What one thread works with; its memory is used again.
  struct Bench {
    std::vector<double> gaps;    // by step: NaN where the cell or one next to it is silent, else 0
    std::vector<double> change;  // by step
    std::vector<const std::vector<PlaceIndex>*> beside;        // the silent components
    std::vector<std::shared_ptr<const Handover>> handed_over;  // by those components
    std::vector<PlaceIndex> reporting;                         // the cell's neighbours that report
    std::vector<PlaceIndex> component;
    Departures::Bench departure;
    NearestSets::Bench nearest;
    std::vector<std::vector<PlaceIndex>> sets;  // of the cell and silent ones; some are spare
    std::size_t set_count = 0;
    std::vector<Moment> moments;
    std::vector<std::size_t> here;  // positions in the cell of its stations that report
  };

  void add_in_month(StepRows rows, std::size_t month);
  std::vector<double> at_gauges(const NormalMonth& month) const;
  void count_alone();
  void take(PlaceIndex cell, Bench& bench);
  void find_gaps(PlaceIndex cell, Bench& bench) const;
  void take_steps_without_gaps(PlaceIndex cell, Bench& bench);
  void take_step(PlaceIndex cell, std::size_t step, Bench& bench);
  bool find_moments_by_sets(PlaceIndex cell, std::size_t step, Bench& bench);
  bool begin_sets(PlaceIndex cell, std::size_t step, Bench& bench) const;
  static void begin_set(PlaceIndex cell, Bench& bench);
  static void add_change(const Moment& change, std::vector<Moment>& moments);
  static bool add_set(std::size_t grown, PlaceIndex by, Bench& bench);
  void find_components(PlaceIndex cell, std::size_t step, Bench& bench);
  void find_moments(PlaceIndex cell, Bench& bench) const;
  void find_changes(PlaceIndex cell, std::size_t step, Bench& bench);
  static std::size_t silent_beside(const Bench& bench);
  void find_changes_beside_silent(PlaceIndex cell, std::size_t step, Bench& bench);
  void find_changes_of_joint(PlaceIndex cell, std::size_t step, Bench& bench);
  void add_changes(const Handover& handover, double sign, PlaceIndex cell, std::size_t step,
                   std::vector<Moment>& moments) const;
  void share(PlaceIndex cell, std::size_t step, const Moment& moment,
             const std::vector<std::size_t>& here);
  const Handover& handover_of(PlaceIndex cell);
  Part& part_of(PlaceIndex cell, std::uint32_t basin);

  const Handovers& handovers_;
  HandoverCache remembered_;
  Departures departures_;
  NearestSets nearest_;
  unsigned threads_;
  std::size_t year_;   // the place of the year among the months of the normals
  std::size_t month_;  // the place of the month of the steps at hand
  std::vector<std::vector<double>> normals_;  // by month, then by station; empty without
  std::vector<BasinWeights> full_;
  CellReadings readings_;
  StepRows rows_;  // of the block at hand
  std::vector<Cell> cells_;
  std::vector<Bench> benches_;      // by thread
  std::vector<std::size_t> alone_;  // by station: steps in which it alone reports
  std::size_t steps_with_values_ = 0;
};

}  // namespace thiessen
