#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "rainfall/gaps/handover.h"
#include "rainfall/gaps/handover_cache.h"
#include "rainfall/gaps/retessellation.h"

namespace thiessen {

/// Retessellation for Thiessen's method: the weights of a step are those of the cells of the gauges
/// that report. Gauges at places that rounding cannot tell apart share a cell.
///
/// Cost of a step: its gauges, the full network's weights and the silent cells' neighbours; and,
/// for each component of silent cells that is not remembered, Handovers::of.
class CellRetessellation : public Retessellation {
 public:
  /// The handovers must outlive this object; up to `remembered_bytes` of them are remembered.
  /// Without `counts_gauges` the values have 0 gauges, which is cheaper.
  CellRetessellation(const Handovers& handovers, std::size_t remembered_bytes, bool counts_gauges);

  const std::vector<BasinWeights>& full_weights() const override { return full_; }
  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinRainfall> at(std::span<const double> readings,
                                CellAccount& account) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override;
  std::vector<CellWeight> full_cells() const override { return handovers_.full(); }
  std::vector<double> cell_readings(std::span<const double> readings) const override;

 private:
  /// What the cells read at one step, and what the silent ones hand over.
  struct State {
    std::vector<double> of_cell;  ///< by cell: the mean of its stations that report; NaN: none
    std::vector<std::shared_ptr<const Handover>> handovers;
    bool any = false;  ///< whether any cell reports
  };

  State state_of(std::span<const double> readings) const;
  std::vector<BasinRainfall> rainfall(const State& state, std::span<const double> readings) const;
  std::vector<CellWeight> change(const State& state) const;
  std::vector<CellWeight> weights(const State& state) const;

  const Handovers& handovers_;
  mutable HandoverCache remembered_;
  bool counts_gauges_;
  std::vector<BasinWeights> full_;
  /// The full network's weights of cells: the first one of each basin, then the second of each, and
  /// so on. In this order an addition need not wait for the one before it, for they are to
  /// different sums.
  std::vector<CellWeight> full_in_turn_;
};

}  // namespace thiessen
