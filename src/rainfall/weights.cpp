#include "rainfall/weights.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/parallel.h"

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

template <typename Part>
void sort_by_station(std::vector<Part>& parts) {
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.station < b.station; });
}

}  // namespace

/// The places at which a station reports, and their diagram.
class Weighing::Reporting {
 public:
  Reporting(const Weighing& weighing, const std::vector<bool>& reports, unsigned threads)
      : network_(weighing.network_) {
    std::vector<Point> positions;
    for (std::uint32_t p = 0; p < network_.places().size(); ++p) {
      std::vector<StationIndex> here;
      for (const StationIndex s : network_.stations_at(PlaceIndex{p})) {
        if (reports[index(s)]) here.push_back(s);
      }
      if (here.empty()) continue;
      positions.push_back(network_.places()[p]);
      stations_.push_back(std::move(here));
    }
    if (positions.empty()) return;
    diagram_ = weighing.ground_.diagram(positions, weighing.frame_, threads);
    share_cells();
  }

  bool any() const { return !stations_.empty(); }
  const Diagram& diagram() const { return diagram_; }
  /// The stations that share the cell, in file order.
  const std::vector<StationIndex>& stations_of(PlaceIndex cell) const {
    return stations_[index(cell)];
  }

 private:
  // Places that rounding cannot tell apart have one cell together.
  void share_cells() {
    for (std::size_t p = 0; p < stations_.size(); ++p) {
      const std::size_t cell = index(diagram_.cell_of[p]);
      if (cell == p) continue;
      stations_[cell].insert(stations_[cell].end(), stations_[p].begin(), stations_[p].end());
      std::sort(stations_[cell].begin(), stations_[cell].end());
    }
  }

  const Network& network_;
  Diagram diagram_;
  std::vector<std::vector<StationIndex>> stations_;  // by cell
};

Weighing::Weighing(const Network& network, const std::vector<Basin>& basins, const Ground& ground)
    : network_(network),
      basins_(basins),
      ground_(ground),
      surface_(ground.surface()),
      frame_(box_of_all(basins)) {
  areas_.reserve(basins.size());
  for (const Basin& basin : basins) areas_.push_back(area_of(basin, *surface_));
}

// Calls take(b, clipper, reporting) for every basin, with one clipper a worker.
template <typename Take>
void Weighing::for_each_basin(const std::vector<bool>& reports, unsigned threads,
                              const Take& take) const {
  const Reporting reporting(*this, reports, threads);
  if (!reporting.any()) return;
  std::vector<std::unique_ptr<CellClipper>> clippers(std::max(1u, threads));
  in_parallel(basins_.size(), threads, [&](std::size_t worker, std::size_t b) {
    auto& clipper = clippers[worker];
    if (!clipper) clipper = std::make_unique<CellClipper>(reporting.diagram(), *surface_);
    take(b, *clipper, reporting);
  });
}

std::vector<BasinWeights> Weighing::weights(const std::vector<bool>& reports,
                                            unsigned threads) const {
  std::vector<BasinWeights> all(basins_.size());
  for (std::size_t b = 0; b < basins_.size(); ++b) all[b].area = areas_[b];
  for_each_basin(reports, threads,
                 [&](std::size_t b, CellClipper& clipper, const Reporting& reporting) {
                   for (const CellShare& share : clipper.shares(basins_[b])) {
                     const auto& stations = reporting.stations_of(share.place);
                     const double area = share.area / static_cast<double>(stations.size());
                     for (const StationIndex s : stations)
                       all[b].stations.push_back({s, area, area / areas_[b]});
                   }
                   sort_by_station(all[b].stations);
                 });
  return all;
}

std::vector<std::vector<StationCell>> Weighing::cells(const std::vector<bool>& reports,
                                                      unsigned threads) const {
  std::vector<std::vector<StationCell>> all(basins_.size());
  for_each_basin(reports, threads,
                 [&](std::size_t b, CellClipper& clipper, const Reporting& reporting) {
                   for (const ClippedCell& cell : clipper.cells(basins_[b])) {
                     const auto& stations = reporting.stations_of(cell.place);
                     const double area = cell.area / static_cast<double>(stations.size());
                     for (const StationIndex s : stations)
                       all[b].push_back({s, area, area / areas_[b], cell.shape});
                   }
                   sort_by_station(all[b]);
                 });
  return all;
}

}  // namespace thiessen
