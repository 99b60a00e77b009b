#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "diagram/plane_diagram.h"
#include "earth/yardstick.h"
#include "rainfall/network/network.h"
#include "rainfall/network/reporting.h"

namespace thiessen {

/// What the edges of cells are for: see Yardstick.
enum class Edges { measured, drawn };

/// The cells of a network's gauges, or of those that report. A cell belongs to one place at which a
/// gauge reports, or to several such places that rounding cannot tell apart.
class NetworkCells {
 public:
  /// `reports` has one entry for each station. The network must outlive this object. Cost: that of
  /// Yardstick::diagram. There is no more of a diagram than `needs` says, but on the Earth
  /// what its ground leaves out.
  NetworkCells(const Network& network, const ReportingStations& reports, const Yardstick& yardstick,
               const Box& frame, unsigned threads, Edges edges = Edges::measured,
               const PlaneNeeds& needs = {});

  bool any() const { return !first_.empty(); }
  /// The diagram of the cells. Its places are those of the network at which a gauge reports, in the
  /// same order.
  const Diagram& diagram() const { return diagram_; }
  /// The stations that share a cell, in the order of their file; none where a place has no cell of
  /// its own.
  std::span<const StationIndex> stations_of(PlaceIndex cell) const {
    const std::size_t first = first_[index(cell)];
    return std::span(stations_).subspan(first, first_[index(cell) + 1] - first);
  }

 private:
  void share_cells(const std::vector<PlaceIndex>& place_of_station,
                   const std::vector<StationIndex>& stations);

  Diagram diagram_;
  std::vector<std::size_t> first_;  // by cell: where its stations begin in stations_
  std::vector<StationIndex> stations_;
};

}  // namespace thiessen
