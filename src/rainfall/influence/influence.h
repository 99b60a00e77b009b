#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "rainfall/gaps/handover.h"
#include "rainfall/gaps/handover_cache.h"
#include "rainfall/influence/cell_readings.h"

namespace thiessen {

/// What a gauge is worth to a basin: how much the areal rainfall changes when it is left out.
struct GaugeInfluence {
  StationIndex station;
  double weight;       ///< the full network's; 0: it weighs only where others are silent
  double rms_change;   ///< root mean square of the changes, in the readings' unit; NaN: no value is
                       ///< left without it in any step
  double mean_change;  ///< their mean: above 0 where the values without it are higher
};

/// How much a basin's areal rainfall changes when a gauge is left out, over a series of steps.
///
/// The change of a step is the value without the gauge's reading less the value with it, both of
/// the tessellation of the gauges that report (Retessellation): one deletion, taken back. All
/// steps count in which both values can be had: where the gauge itself is silent the change is 0,
/// where it alone reports there is none. That is what comparing the series with the one computed
/// from a file without the gauge's column gives: to 1e-12 of the largest reading in a plane, on the
/// Earth to what silent gauges' values are good for (2e-11 in Colorado, 1e-7 where gauges are 100
/// km apart), for ground that the gauge has no part in is handed over in another chart without it.
///
/// With a gauge its cell falls silent, and with it the silent components beside it become one: what
/// that hands over, less what they did, is who gets the cell's ground (see Handovers). The change
/// is the sum of weight x (their reading - the gauge's own). Where all its neighbours report, a
/// step costs a multiplication for each of them and each basin; where some are silent their common
/// handover is looked up, and computed where it is not remembered. Of several stations that report
/// in a cell, one's leaving moves the cell's mean and nothing else. So readings that are all the
/// same change by 0.
///
/// Every cell's sums are formed in the order of the steps, so they do not depend on the threads.
/// Memory: the block of steps, and the sums: 48 bytes for each basin and gauge that weighs in it.
class Influence {
 public:
  /// The handovers must outlive it. `remembered_bytes`: of handovers.
  Influence(const Handovers& handovers, std::size_t remembered_bytes, unsigned threads);

  /// The next steps of the series.
  void add(StepRows rows);

  /// By basin, in the order of the stations: those that weigh in the basin in the full network, or
  /// in a step that counts.
  std::vector<std::vector<GaugeInfluence>> result() const;

 private:
  /// Of changes, in a range that no square leaves.
  struct Sums {
    long double changes = 0;
    long double squares = 0;
    bool weighs = false;  ///< in the full network, or in a step that counts

    void add(double change) {
      weighs = true;
      changes += change;
      squares += static_cast<long double>(change) * change;
    }
  };
  /// A cell's part in one basin.
  struct Part {
    std::uint32_t basin;
    double weight;           ///< the full network's
    std::vector<Sums> sums;  ///< by station of the cell
  };
  struct Cell {
    std::vector<Part> parts;                   ///< by basin
    std::shared_ptr<const Handover> handover;  ///< of the cell alone
  };
  /// A cell's part in one basin at one step.
  struct Moment {
    std::uint32_t basin;
    double weight;
    double change;  ///< where the cell falls silent
  };
  /// What a thread works in.
  struct Bench {
    std::vector<double> gaps;    // by step: NaN where the cell or one next to it is silent, else 0
    std::vector<double> change;  // by step
    std::vector<const std::vector<PlaceIndex>*> beside;        // the silent components
    std::vector<std::shared_ptr<const Handover>> handed_over;  // by these
    std::vector<PlaceIndex> component;
    std::vector<Moment> moments;
    std::vector<std::size_t> here;  // stations of the cell that report, by their place in it
  };

  void count_alone();
  void take(PlaceIndex cell, Bench& bench);
  void find_gaps(PlaceIndex cell, Bench& bench) const;
  void take_steps_without_gaps(PlaceIndex cell, Bench& bench);
  void take_step(PlaceIndex cell, std::size_t step, Bench& bench);
  void find_components(PlaceIndex cell, std::size_t step, Bench& bench);
  void find_moments(PlaceIndex cell, Bench& bench) const;
  void find_changes(PlaceIndex cell, std::size_t step, Bench& bench);
  void share(PlaceIndex cell, std::size_t step, const Moment& moment,
             const std::vector<std::size_t>& here);
  const Handover& handover_of(PlaceIndex cell);
  Part& part_of(PlaceIndex cell, std::uint32_t basin);

  const Handovers& handovers_;
  HandoverCache remembered_;
  unsigned threads_;
  std::vector<BasinWeights> full_;
  CellReadings readings_;
  StepRows rows_;  // of the block at hand
  std::vector<Cell> cells_;
  std::vector<Bench> benches_;      // by thread
  std::vector<std::size_t> alone_;  // by station: steps in which it alone reports
  std::size_t steps_with_values_ = 0;
};

}  // namespace thiessen
