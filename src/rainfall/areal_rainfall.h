#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "rainfall/full_network.h"
#include "rainfall/gaps/handover.h"
#include "rainfall/gaps/handover_cache.h"
#include "rainfall/step_rainfall.h"
#include "rainfall/weights.h"

namespace thiessen {

/// What values at one time are made of, by cell: a cell's stations, that of a place where silent
/// gauges hand nothing over, count as one gauge.
struct CellAccount {
  std::vector<double> readings;  ///< by cell, the mean of its stations that report; NaN: none does
  /// What is added to the full network's weights, in any order and perhaps in several parts; then
  /// all of a basin are divided by their sum.
  std::vector<CellWeight> change;
};

struct ArealRainfallSettings {
  Gaps gaps = Gaps::retessellate;
  std::size_t min_gauges = 1;  ///< fewer that weigh give no value
  bool accounts = true;        ///< whether `gauges` and `coverage` are wanted, else they are 0
  std::size_t remembered_bytes = std::size_t{256} << 20;  ///< of handovers
};

/// Turns readings into areal rainfall. The weighing must outlive it. Safe for several threads at
/// once. What it gives depends on the readings alone, not on what it remembers. Cost of a step: its
/// gauges, the full network's weights and the silent cells' neighbours; for each component of
/// silent cells that is not remembered also Handovers::of.
class ArealRainfall : public StepRainfall {
 public:
  /// Of the method, among those of src/rainfall/methods.
  static constexpr const char* name = "thiessen";

  ArealRainfall(const Weighing& weighing, const ArealRainfallSettings& settings, unsigned threads);

  /// The full network's weights.
  const std::vector<BasinWeights>& full_weights() const { return full_; }

  /// What it retessellates with; null where `gaps` says otherwise.
  const Handovers* handovers() const { return handovers_.get(); }

  /// By basin.
  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override;

  /// The same, and what the values are made of; where a basin has none its change says nothing.
  std::vector<BasinRainfall> at(std::span<const double> readings, CellAccount& account) const;

  /// The full network's weights of the account's cells, by basin, then by cell.
  std::vector<CellWeight> full_cells() const;
  /// The account's readings.
  std::vector<double> cell_readings(std::span<const double> readings) const;

 private:
  /// What the cells read and hand over at one time.
  struct State {
    std::vector<double> of_cell;  ///< the mean of those in the cell that report; NaN: none does
    std::vector<std::shared_ptr<const Handover>> handovers;
    bool any = false;
  };

  State state_of(std::span<const double> readings) const;
  std::vector<BasinRainfall> retessellated(const State& state,
                                           std::span<const double> readings) const;
  std::vector<CellWeight> change_of(const State& state) const;
  std::vector<CellWeight> silent_weights(std::span<const double> readings) const;
  void add_coverage(std::span<const double> readings, std::vector<BasinRainfall>& result) const;
  void count_gauges(const State& state, std::span<const double> readings,
                    std::vector<BasinRainfall>& result) const;
  std::vector<CellWeight> weights_of(const State& state) const;
  std::size_t reporting_in(PlaceIndex cell, std::span<const double> readings) const;

  ArealRainfallSettings settings_;
  const Network& network_;
  std::unique_ptr<const Handovers> handovers_;  // to retessellate
  mutable std::unique_ptr<HandoverCache> remembered_;
  std::vector<BasinWeights> full_;
  /// The full network's weights of cells, first one of each basin, then the next of each: sums that
  /// do not wait for each other.
  std::vector<CellWeight> full_in_turn_;
};

}  // namespace thiessen
