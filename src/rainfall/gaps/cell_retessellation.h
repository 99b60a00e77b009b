#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "geometry/long_sum.h"
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
  /// The handovers and the cache of them must outlive this object; others may use the cache too.
  /// The normals that count are those of a month, or of the year. Without `counts_gauges` the
  /// values have 0 gauges, which is cheaper.
  CellRetessellation(const Handovers& handovers, HandoverCache& remembered,
                     const NormalMonth& month, bool counts_gauges);

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
    /// By cell: the mean of its stations that report, of readings relative to normals; NaN: none.
    std::vector<double> of_cell;
    std::vector<std::shared_ptr<const Handover>> handovers;
    bool any = false;  ///< whether any cell reports
  };

  /// A cell's part in a basin at one step.
  struct CellPart {
    CellWeight part;
    double covered;  ///< how much of the weight is of ground that has normals
    double normals;  ///< that times the mean normal there
  };

  State state_of(std::span<const double> readings) const;
  void read_cells(std::span<const double> readings, std::vector<double>& of_cell) const;
  double reading_of(std::span<const StationIndex> stations, std::span<const double> readings) const;
  std::vector<BasinRainfall> rainfall(const State& state, std::span<const double> readings) const;
  void count_gauges(const State& state, std::span<const double> readings,
                    std::vector<BasinRainfall>& result) const;
  void keep_parts();
  void keep_turns(const std::vector<CellWeight>& weights);
  /// The basins in which a cell weighs when all gauges report.
  std::span<const std::uint32_t> basins_of(PlaceIndex cell) const {
    const std::size_t first = first_basin_[index(cell)];
    return std::span(basins_).subspan(first, first_basin_[index(cell) + 1] - first);
  }
  void add_linearly(const State& state, std::vector<LongSum>& sums) const;
  void add_in_parts(const State& state, const std::vector<CellPart>& parts,
                    std::vector<LongSum>& sums) const;
  double normal_of(const CellPart& part) const;
  std::vector<CellWeight> change(const State& state) const;
  CellPart part_of(const CellWeight& weight, const WeightedNormals& weighted,
                   std::size_t number) const;
  std::vector<CellPart> parts(const State& state) const;

  const Handovers& handovers_;
  HandoverCache& remembered_;
  NormalMonth month_;
  std::size_t figure_;             // the month's among those of WeightedNormals
  std::vector<double> at_gauges_;  // the normals by station; empty without
  bool counts_gauges_;
  std::vector<BasinWeights> full_;
  /// By basin: where its sum stands, those of the basins with the most weights first.
  std::vector<std::uint32_t> sum_of_;
  /// The full network's weights of cells in turns: the first one of each basin, then the second of
  /// each that has one, and so on, each in the order of the sums. So a turn is added to sums side
  /// by side, none of which waits for another. With normals these are weight x normal.
  std::vector<double> weights_in_turn_;
  std::vector<PlaceIndex> cells_in_turn_;
  std::vector<std::uint32_t> first_in_turn_;  // where each turn begins, and the last one ends
  /// The basins in which each cell weighs when all gauges report: those of a cell begin at its
  /// entry in first_basin_.
  std::vector<std::uint32_t> basins_;
  std::vector<std::size_t> first_basin_;
  std::vector<PlaceIndex> shared_cells_;  ///< those of several stations
  /// The cells of one station, and those stations.
  std::vector<PlaceIndex> single_cells_;
  std::vector<StationIndex> single_stations_;
  std::vector<std::size_t> full_gauges_;  ///< by basin: how many weigh when all report
};

}  // namespace thiessen
