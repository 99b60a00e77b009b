#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "basin/basin.h"
#include "basin/cell_clipper.h"
#include "earth/yardstick.h"
#include "rainfall/network.h"
#include "rainfall/reporting.h"

namespace thiessen {

/// A station's part in a basin.
struct StationWeight {
  StationIndex station;
  double area;    ///< of its cell within the basin; square metres, or the plane's unit squared
  double weight;  ///< that area's share of the basin, in (0, 1]
};

/// The weights of one basin, positive ones only, in the order of the stations. They add up to 1
/// within 2e-13.
struct BasinWeights {
  double area = 0;
  std::vector<StationWeight> stations;
};

/// Adds a cell's area in equal shares to the stations that share it.
void add_shares(BasinWeights& basin, std::span<const StationIndex> stations, double area);

template <typename Part>
void sort_by_station(std::vector<Part>& parts) {
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.station < b.station; });
}

/// A station's cell within a basin.
struct StationCell {
  StationIndex station;
  double area;
  double weight;
  MultiPolygon shape;
};

/// Tessellates a network, or those of its gauges that report, and weighs them in the basins.
/// The network and the basins must outlive it. Safe for several threads at once.
class Weighing {
 public:
  Weighing(const Network& network, const std::vector<Basin>& basins, const Yardstick& yardstick);

  const Network& network() const { return network_; }
  const std::vector<Basin>& basins() const { return basins_; }
  const Yardstick& yardstick() const { return yardstick_; }
  const Box& frame() const { return frame_; }
  const Surface& surface() const { return *surface_; }
  double basin_area(std::size_t basin) const { return areas_[basin]; }

  /// The weights in every basin, by basin. `reports` has one entry a station; a place whose
  /// stations report in part belongs to those that do. Empty weights where none reports. Cost: the
  /// tessellation's n log n, and what CellClipper takes for each basin.
  std::vector<BasinWeights> weights(const ReportingStations& reports, unsigned threads) const;

  /// The same with the shapes of the cells, by basin, in the order of the stations; stations at one
  /// place have each the whole shape and their share of its area.
  std::vector<std::vector<StationCell>> cells(const ReportingStations& reports,
                                              unsigned threads) const;

 private:
  template <typename Take>
  void for_each_basin(const ReportingStations& reports, unsigned threads, const Take& take) const;

  const Network& network_;
  const std::vector<Basin>& basins_;
  Yardstick yardstick_;
  std::unique_ptr<Surface> surface_;
  Box frame_;
  std::vector<double> areas_;
};

}  // namespace thiessen
