#pragma once

#include <vector>

#include "earth/ground.h"
#include "rainfall/network.h"

namespace thiessen {

/// The cells of a network's gauges, or of those that report. A cell belongs to a place with a gauge
/// that does, or to several that rounding cannot tell apart.
class NetworkCells {
 public:
  /// `reports` has one entry a station. The network must outlive it. Cost: Ground::diagram's.
  NetworkCells(const Network& network, const std::vector<bool>& reports, const Ground& ground,
               const Box& frame, unsigned threads);

  bool any() const { return !stations_.empty(); }
  /// Its places are those of the network at which a gauge reports, in their order.
  const Diagram& diagram() const { return diagram_; }
  /// The stations that share a cell, in file order; none where a place has no cell of its own.
  const std::vector<StationIndex>& stations_of(PlaceIndex cell) const {
    return stations_[index(cell)];
  }

 private:
  void share_cells();

  Diagram diagram_;
  std::vector<std::vector<StationIndex>> stations_;  // by cell
};

}  // namespace thiessen
