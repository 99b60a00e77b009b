#include "rainfall/network/weights.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/parallel.h"
#include "rainfall/network/network_cells.h"

namespace thiessen {
namespace {

Box box_of_all(const std::vector<Basin>& basins) {
  Box box;
  for (const Basin& basin : basins) {
    for (const Polygon& part : basin.shape) {
      for (const Point p : part.outer) box.take_in(p);
    }
  }
  return box;
}

}  // namespace

void add_shares(BasinWeights& basin, std::span<const StationIndex> stations, double area) {
  const double share = area / static_cast<double>(stations.size());
  for (const StationIndex s : stations)
    basin.stations.push_back({s, share, std::min(share / basin.area, 1.0)});
}

Weighing::Weighing(const Network& network, const std::vector<Basin>& basins,
                   const Yardstick& yardstick)
    : network_(network),
      basins_(basins),
      yardstick_(yardstick),
      surface_(yardstick.surface()),
      frame_(box_of_all(basins)) {
  areas_.reserve(basins.size());
  for (const Basin& basin : basins) areas_.push_back(area_of(basin, *surface_));
}

// Calls take(b, clipper, reporting) for every basin. Each worker has a clipper of its own, for a
// clipper is not safe for several threads.
template <typename Take>
void Weighing::for_each_basin(const ReportingStations& reports, unsigned threads,
                              const Take& take) const {
  const NetworkCells reporting(network_, reports, yardstick_, frame_, threads);
  if (!reporting.any()) return;
  std::vector<std::unique_ptr<CellClipper>> clippers(std::max(1u, threads));
  in_parallel(basins_.size(), threads, [&](std::size_t worker, std::size_t b) {
    auto& clipper = clippers[worker];
    if (!clipper) clipper = std::make_unique<CellClipper>(reporting.diagram(), *surface_);
    take(b, *clipper, reporting);
  });
}

std::vector<BasinWeights> Weighing::weights(const ReportingStations& reports,
                                            unsigned threads) const {
  std::vector<BasinWeights> all(basins_.size());
  for (std::size_t b = 0; b < basins_.size(); ++b) all[b].area = areas_[b];
  for_each_basin(reports, threads,
                 [&](std::size_t b, CellClipper& clipper, const NetworkCells& reporting) {
                   for (const CellShare& share : clipper.shares(basins_[b]))
                     add_shares(all[b], reporting.stations_of(share.place), share.area);
                   sort_by_station(all[b].stations);
                 });
  return all;
}

std::vector<std::vector<StationCell>> Weighing::cells(const ReportingStations& reports,
                                                      unsigned threads) const {
  std::vector<std::vector<StationCell>> all(basins_.size());
  for_each_basin(reports, threads,
                 [&](std::size_t b, CellClipper& clipper, const NetworkCells& reporting) {
                   for (const ClippedCell& cell : clipper.cells(basins_[b])) {
                     const auto& stations = reporting.stations_of(cell.place);
                     const double area = cell.area / static_cast<double>(stations.size());
                     for (const StationIndex s : stations)
                       all[b].push_back({s, area, std::min(area / areas_[b], 1.0), cell.shape});
                   }
                   sort_by_station(all[b]);
                 });
  return all;
}

}  // namespace thiessen
