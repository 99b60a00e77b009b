#include "rainfall/network/network_cells.h"

#include <algorithm>
#include <utility>

namespace thiessen {

NetworkCells::NetworkCells(const Network& network, const ReportingStations& reports,
                           const Yardstick& yardstick, const Box& frame, unsigned threads,
                           Edges edges, const PlaneNeeds& needs) {
  std::vector<Point> positions;
  std::vector<StationIndex> stations;  // that report, by place
  std::vector<PlaceIndex> place_of_station;
  for (std::uint32_t p = 0; p < network.places().size(); ++p) {
    const std::size_t before = stations.size();
    for (const StationIndex s : network.stations_at(PlaceIndex{p})) {
      if (reports[s]) stations.push_back(s);
    }
    if (stations.size() == before) continue;
    place_of_station.resize(stations.size(),
                            PlaceIndex{static_cast<std::uint32_t>(positions.size())});
    positions.push_back(network.places()[p]);
  }
  if (positions.empty()) return;
  if (yardstick.metric == Metric::planar) {
    diagram_ = plane_diagram(positions, frame, needs);
  } else {
    const auto neighbours = needs.neighbours ? Neighbours::wanted : Neighbours::left_out;
    diagram_ = edges == Edges::drawn
                   ? yardstick.drawn_diagram(positions, frame, threads, neighbours)
                   : yardstick.diagram(positions, frame, threads, neighbours);
  }
  share_cells(place_of_station, stations);
}

// Places that rounding cannot tell apart have one cell together: their stations all share it.
void NetworkCells::share_cells(const std::vector<PlaceIndex>& place_of_station,
                               const std::vector<StationIndex>& stations) {
  std::vector<std::pair<PlaceIndex, StationIndex>> in_cells;
  in_cells.reserve(stations.size());
  for (std::size_t i = 0; i < stations.size(); ++i)
    in_cells.emplace_back(diagram_.cell_of[index(place_of_station[i])], stations[i]);
  // They are in order already but where a cell is shared.
  if (!std::is_sorted(in_cells.begin(), in_cells.end()))
    std::sort(in_cells.begin(), in_cells.end());
  first_.assign(diagram_.places.size() + 1, 0);
  stations_.reserve(stations.size());
  for (const auto& [cell, station] : in_cells) {
    ++first_[index(cell) + 1];
    stations_.push_back(station);
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

}  // namespace thiessen
