#include "rainfall/network/weights.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "base/interrupt.h"
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

/// Gives the cells their measured areas; false where there are cells without area, or the reverse.
bool take_areas(std::vector<ClippedCell>& cells, const std::vector<CellShare>& shares) {
  const auto is_same = [](const ClippedCell& cell, const CellShare& share) {
    return cell.place == share.place;
  };
  if (!std::equal(cells.begin(), cells.end(), shares.begin(), shares.end(), is_same)) return false;
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i].area = shares[i].area;
  return true;
}

}  // namespace

void add_shares(BasinWeights& basin, std::span<const StationIndex> stations, double area) {
  const double share = area / static_cast<double>(stations.size());
  for (const StationIndex s : stations)
    basin.stations.push_back({s, share, std::min(share / basin.area, 1.0)});
}

Weighing::Weighing(const Network& network, const std::vector<Basin>& basins,
                   const std::vector<Basin>& drawn, const Yardstick& yardstick)
    : network_(network),
      basins_(basins),
      drawn_(drawn),
      yardstick_(yardstick),
      surface_(yardstick.surface()),
      frame_(box_of_all(basins)) {
  areas_.reserve(basins.size());
  for (const Basin& basin : basins) areas_.push_back(area_of(basin, *surface_));
}

/// The cells of the reporting gauges with edges of one kind, and the clippers of the threads: each
/// has its own, for a clipper is not safe for several.
class Weighing::Clipping {
 public:
  Clipping(const Weighing& weighing, const ReportingStations& reports, unsigned threads,
           Edges edges)
      : Clipping(weighing, reports, threads, edges, weighing.yardstick_) {}
  Clipping(const Weighing& weighing, const ReportingStations& reports, unsigned threads,
           Edges edges, const Yardstick& yardstick)
      : surface_(*weighing.surface_),
        basins_(edges == Edges::drawn ? weighing.drawn_ : weighing.basins_),
        cells_(weighing.network_, reports, yardstick,
               edges == Edges::drawn ? box_of_all(weighing.drawn_) : weighing.frame_, threads,
               edges),
        clippers_(std::max(1u, threads)) {}

  bool any() const { return cells_.any(); }
  std::span<const StationIndex> stations_of(PlaceIndex place) const {
    return cells_.stations_of(place);
  }
  std::vector<CellShare> shares(std::size_t worker, std::size_t basin) {
    return clipper(worker).shares(basins_[basin]);
  }
  std::vector<ClippedCell> cells(std::size_t worker, std::size_t basin) {
    return clipper(worker).cells(basins_[basin]);
  }

 private:
  CellClipper& clipper(std::size_t worker) {
    auto& clipper = clippers_[worker];
    if (!clipper) clipper = std::make_unique<CellClipper>(cells_.diagram(), surface_);
    return *clipper;
  }

  const Surface& surface_;
  const std::vector<Basin>& basins_;
  NetworkCells cells_;
  std::vector<std::unique_ptr<CellClipper>> clippers_;
};

std::vector<BasinWeights> Weighing::weights(const ReportingStations& reports,
                                            unsigned threads) const {
  std::vector<BasinWeights> all(basins_.size());
  for (std::size_t b = 0; b < basins_.size(); ++b) all[b].area = areas_[b];
  Clipping measured(*this, reports, threads, Edges::measured);
  if (!measured.any()) return all;
  in_parallel(basins_.size(), threads, [&](std::size_t worker, std::size_t b) {
    for (const CellShare& share : measured.shares(worker, b))
      add_shares(all[b], measured.stations_of(share.place), share.area);
    sort_by_station(all[b].stations);
  });
  return all;
}

std::vector<std::vector<StationCell>> Weighing::cells(const ReportingStations& reports,
                                                      unsigned threads) const {
  std::vector<std::vector<StationCell>> all(basins_.size());
  Clipping measured(*this, reports, threads, Edges::measured);
  if (!measured.any()) return all;
  std::optional<Clipping> drawn;
  if (!yardstick_.draws_as_measured()) drawn.emplace(*this, reports, threads, Edges::drawn);
  in_parallel(basins_.size(), threads, [&](std::size_t worker, std::size_t b) {
    std::vector<ClippedCell> clipped;
    if (drawn) clipped = drawn->cells(worker, b);
    if (!drawn || !take_areas(clipped, measured.shares(worker, b)))
      clipped = measured.cells(worker, b);
    all[b] = by_station(clipped, measured, b);
  });
  return all;
}

std::vector<StationCell> Weighing::by_station(const std::vector<ClippedCell>& cells,
                                              const Clipping& clipping, std::size_t basin) const {
  std::vector<StationCell> found;
  for (const ClippedCell& cell : cells) {
    throw_if_interrupted();
    const auto stations = clipping.stations_of(cell.place);
    const double area = cell.area / static_cast<double>(stations.size());
    for (const StationIndex s : stations)
      found.push_back({s, area, std::min(area / areas_[basin], 1.0), cell.shape});
  }
  sort_by_station(found);
  return found;
}

std::vector<std::vector<StationCell>> Weighing::pictured_cells(const ReportingStations& reports,
                                                               double tolerance,
                                                               unsigned threads) const {
  std::vector<std::vector<StationCell>> all(basins_.size());
  Yardstick yardstick = yardstick_;
  yardstick.tolerance = tolerance;
  Clipping drawn(*this, reports, threads, Edges::drawn, yardstick);
  if (!drawn.any()) return all;
  in_parallel(basins_.size(), threads, [&](std::size_t worker, std::size_t b) {
    all[b] = by_station(drawn.cells(worker, b), drawn, b);
  });
  return all;
}

}  // namespace thiessen
