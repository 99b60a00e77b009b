#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rainfall/gaps/cell_adjacency.h"
#include "rainfall/influence/step_blocks.h"
#include "rainfall/network/network_cells.h"

namespace thiessen {

/// What the cells read in a block of steps, and which of them are silent together. The steps of a
/// cell lie side by side in memory.
class CellReadings {
 public:
  /// The cells and their adjacency must outlive this object.
  CellReadings(const NetworkCells& cells, const CellAdjacency& adjacency)
      : cells_(cells), adjacency_(adjacency) {}
  /// Has readings count relative to their gauges' normals, one for each station.
  void take_normals(std::vector<double> at_gauges) { at_gauges_ = std::move(at_gauges); }
  /// What a reading of a station counts as.
  double relative(StationIndex station, double reading) const {
    return at_gauges_.empty() ? reading : reading / at_gauges_[index(station)];
  }

  /// Takes up a block in place of the one before. The rows are not looked at after this call. Cost:
  /// the stations of every step, and the neighbours of silent cells.
  void take_up(StepRows rows, unsigned threads);

  std::size_t steps() const { return steps_.size(); }
  /// The readings of a cell by step: the mean of its stations that report, NaN where none does.
  std::span<const double> of(PlaceIndex cell) const {
    return std::span(values_).subspan(index(cell) * steps(), steps());
  }
  /// How many stations of the whole network report at a step.
  std::size_t reporting(std::size_t step) const { return steps_[step].reporting; }
  /// The connected component of silent cells that a cell belongs to at a step, in rising order.
  /// Requires that the cell is silent then.
  const std::vector<PlaceIndex>& component_of(PlaceIndex silent, std::size_t step) const {
    return steps_[step].components[component_[index(silent) * steps() + step]];
  }

 private:
  struct Step {
    std::size_t reporting = 0;
    std::vector<std::vector<PlaceIndex>> components;
  };

  void take_up(std::size_t step, std::span<const double> readings);

  const NetworkCells& cells_;
  const CellAdjacency& adjacency_;
  std::vector<double> at_gauges_;  // empty without normals
  std::vector<Step> steps_;
  std::vector<double> values_;            // by cell, then by step
  std::vector<std::uint32_t> component_;  // by cell, then by step; only for silent cells
};

}  // namespace thiessen
