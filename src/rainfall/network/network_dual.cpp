#include "rainfall/network/network_dual.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace thiessen {

NetworkDual network_dual(const Network& network, const ReportingStations& reports,
                         const Yardstick& yardstick, unsigned threads) {
  NetworkDual result;
  std::vector<Point> positions;
  std::vector<StationIndex> first_at;  // by place
  for (std::uint32_t p = 0; p < network.places().size(); ++p) {
    const std::size_t before = positions.size();
    for (const StationIndex s : network.stations_at(PlaceIndex{p})) {
      if (!reports[s]) continue;
      if (positions.size() > before) {
        ++result.left_out;
        continue;
      }
      positions.push_back(network.places()[p]);
      first_at.push_back(s);
    }
  }
  result.places = positions.size();
  if (positions.empty()) return result;
  const Dual dual = yardstick.dual(positions, threads);
  const auto station = [&](PlaceIndex place) { return first_at[index(place)]; };
  for (const DualTriangle& corners : dual.triangles) {
    std::array<StationIndex, 3> triangle{station(corners[0]), station(corners[1]),
                                         station(corners[2])};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    result.triangles.push_back(triangle);
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  for (const Border& border : dual.borders) {
    const auto [low, high] = std::minmax({station(border.first), station(border.second)});
    result.borders.push_back({low, high, border.length});
  }
  std::sort(result.borders.begin(), result.borders.end(),
            [](const StationBorder& a, const StationBorder& b) {
              return std::tie(a.station, a.neighbour) < std::tie(b.station, b.neighbour);
            });
  return result;
}

}  // namespace thiessen
