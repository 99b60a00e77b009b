#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "basin/basin.h"
#include "basin/cell_clipper.h"
#include "earth/yardstick.h"
#include "rainfall/network/network.h"
#include "rainfall/network/reporting.h"
#include "rainfall/normals/normal_field.h"

namespace thiessen {

/// A station's part in a basin.
struct StationWeight {
  StationIndex station;
  double area;    ///< of its cell within the basin; square metres, or the plane's unit squared
  double weight;  ///< that area's share of the basin, in (0, 1]
  /// By what a reading counts more on that ground than at the gauge: the mean normal there divided
  /// by the gauge's. It is 1 without normals.
  double factor = 1;
};

/// The positive weights of one basin, in the order of the stations. They add up to 1 within 2e-13;
/// in a basin on the Earth that is only hundreds of metres wide within 1e-11, for degrees have no
/// more digits there.
struct BasinWeights {
  double area = 0;
  std::vector<StationWeight> stations;
};

/// Adds a cell's area to a basin, in equal shares for the stations that share the cell.
void add_shares(BasinWeights& basin, std::span<const StationIndex> stations, double area);
/// Sets the factors of the stations that were added last, as many as share a cell, by the mean
/// normal over the cell's ground in the basin.
void set_factors(BasinWeights& basin, std::span<const StationIndex> stations, double normal,
                 const NormalField& normals, const NormalMonth& month);

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
  double factor = 1;  ///< see StationWeight
};

/// Tessellates a network, or those of its gauges that report, and weighs the gauges in the basins.
/// Areas and weights do not depend on the yardstick's tolerance, only shapes do. The network and
/// the basins must outlive this object. Safe for several threads at once.
class Weighing {
 public:
  Weighing(const Network& network, const std::vector<Basin>& basins, const Yardstick& yardstick)
      : Weighing(network, basins, basins, yardstick) {}
  /// `drawn` are the basins once more, with curved edges as they are to be drawn; see
  /// StudyParts::drawn_basins.
  Weighing(const Network& network, const std::vector<Basin>& basins,
           const std::vector<Basin>& drawn, const Yardstick& yardstick);

  /// Has gauges weighed with these normals from now on. It is to be called before anything is
  /// computed, and by one thread alone.
  void take_normals(std::shared_ptr<const NormalField> normals) { normals_ = std::move(normals); }
  /// The normals; null where there are none.
  const NormalField* normals() const { return normals_.get(); }

  const Network& network() const { return network_; }
  const std::vector<Basin>& basins() const { return basins_; }
  const Yardstick& yardstick() const { return yardstick_; }
  const Box& frame() const { return frame_; }
  const Surface& surface() const { return *surface_; }
  double basin_area(std::size_t basin) const { return areas_[basin]; }

  /// The weights of the reporting gauges, by basin. `reports` has one entry for each station; where
  /// only some of a place's stations report, the place belongs to those. Where no gauge reports the
  /// weights are empty. Factors are those of the year's normals. Cost: n log n for the
  /// tessellation, and that of CellClipper for each basin.
  std::vector<BasinWeights> weights(const ReportingStations& reports, unsigned threads) const;
  /// The same with the factors of a calendar month.
  std::vector<BasinWeights> weights_in_month(const ReportingStations& reports, unsigned threads,
                                             const NormalMonth& month) const;
  /// The same with the factors of each calendar month in turn, where months have normals of their
  /// own; else the weights alone.
  std::vector<std::vector<BasinWeights>> weights_by_month(const ReportingStations& reports,
                                                          unsigned threads) const;

  /// The cells of the reporting gauges with their shapes, by basin, in the order of the stations.
  /// Stations at one place each have the whole shape and their share of its area. Areas and weights
  /// are those of weights(), and factors those of the month, or of the year. Where a cell with area
  /// has no shape at the tolerance, as a sliver that is narrower, or the other way round, the
  /// basin's cells have the edges that they are measured with.
  std::vector<std::vector<StationCell>> cells(const ReportingStations& reports, unsigned threads,
                                              const NormalMonth& month = {}) const;
  /// Hands the same cells over one at a time, by basin, until `take` returns false. Where edges are
  /// drawn as they are measured, and there are no normals, only what the cells are made from is
  /// held: 50 bytes for each cell of a basin, or with several threads and basins the cells of some
  /// basins.
  void for_each_cell(const ReportingStations& reports, unsigned threads, const NormalMonth& month,
                     const std::function<bool(std::size_t basin, StationCell&& cell)>& take) const;
  /// The same cells for a picture: on the Earth edges are drawn within `tolerance` metres, and
  /// areas and weights are those of what is drawn.
  std::vector<std::vector<StationCell>> pictured_cells(const ReportingStations& reports,
                                                       double tolerance, unsigned threads,
                                                       const NormalMonth& month = {}) const;

 private:
  class Clipping;
  std::vector<std::vector<BasinWeights>> weights_in(const std::vector<NormalMonth>& months,
                                                    const ReportingStations& reports,
                                                    unsigned threads) const;
  class CellsHandedOver;
  std::vector<StationCell> by_station(const std::vector<ClippedCell>& cells,
                                      const Clipping& clipping, std::size_t basin) const;

  const Network& network_;
  const std::vector<Basin>& basins_;
  const std::vector<Basin>& drawn_;
  Yardstick yardstick_;
  std::unique_ptr<Surface> surface_;
  Box frame_;
  std::vector<double> areas_;
  std::shared_ptr<const NormalField> normals_;
};

}  // namespace thiessen
