#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "earth/yardstick.h"
#include "rainfall/network/network.h"
#include "rainfall/network/reporting.h"

namespace thiessen {

/// The whole border between the cells of two stations; see Border.
struct StationBorder {
  StationIndex station;    ///< the one that stands first in the file
  StationIndex neighbour;  ///< the other
  double length;           ///< metres, or the plane's unit; infinite where it never ends
};

/// What the cells of a network's gauges say of the gauges: see Dual. Of stations that share a place
/// the first in the file stands for all. Borders stand in the order of their stations, and so do
/// triangles, whose corners begin with their first.
struct NetworkDual {
  std::vector<std::array<StationIndex, 3>> triangles;  ///< counter-clockwise
  std::vector<StationBorder> borders;
  std::size_t places = 0;    ///< at which a gauge reports
  std::size_t left_out = 0;  ///< stations that report and for which another of their place stands
};

/// Finds the dual of the cells of the gauges that report. `reports` has one entry for each station.
/// Cost: that of Yardstick::dual.
NetworkDual network_dual(const Network& network, const ReportingStations& reports,
                         const Yardstick& yardstick, unsigned threads);

}  // namespace thiessen
