#include "rainfall/network_cells.h"

#include <algorithm>
#include <utility>

namespace thiessen {

NetworkCells::NetworkCells(const Network& network, const std::vector<bool>& reports,
                           const Ground& ground, const Box& frame, unsigned threads) {
  std::vector<Point> positions;
  for (std::uint32_t p = 0; p < network.places().size(); ++p) {
    std::vector<StationIndex> here;
    for (const StationIndex s : network.stations_at(PlaceIndex{p})) {
      if (reports[index(s)]) here.push_back(s);
    }
    if (here.empty()) continue;
    positions.push_back(network.places()[p]);
    stations_.push_back(std::move(here));
  }
  if (positions.empty()) return;
  diagram_ = ground.diagram(positions, frame, threads);
  share_cells();
}

// Places that rounding cannot tell apart have one cell together.
void NetworkCells::share_cells() {
  for (std::size_t p = 0; p < stations_.size(); ++p) {
    const std::size_t cell = index(diagram_.cell_of[p]);
    if (cell == p) continue;
    stations_[cell].insert(stations_[cell].end(), stations_[p].begin(), stations_[p].end());
    std::sort(stations_[cell].begin(), stations_[cell].end());
    stations_[p].clear();
  }
}

}  // namespace thiessen
