#include "rainfall/leaving_out/gauge_groups.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "geometry/box.h"
#include "geometry/hilbert.h"

namespace thiessen {

std::vector<PlaceIndex> along_hilbert_curve(const Network& network) {
  const std::vector<Point>& places = network.places();
  Box box;
  for (const Point p : places) box.take_in(p);
  std::vector<PlaceIndex> order;
  std::vector<std::uint32_t> distances;
  for (std::uint32_t p = 0; p < places.size(); ++p) {
    order.push_back(PlaceIndex{p});
    distances.push_back(hilbert_distance(box, places[p]));
  }
  std::sort(order.begin(), order.end(), [&](PlaceIndex a, PlaceIndex b) {
    return std::tuple(distances[index(a)], places[index(a)].x, places[index(a)].y) <
           std::tuple(distances[index(b)], places[index(b)].x, places[index(b)].y);
  });
  return order;
}

GaugeGroups::GaugeGroups(const Network& network) : of_place(network.places().size()) {
  const std::size_t places = network.places().size();
  count = std::min(places, std::clamp<std::size_t>(places / 4, 5, 30));
  const std::vector<PlaceIndex> order = along_hilbert_curve(network);
  for (std::size_t i = 0; i < places; ++i) of_place[index(order[i])] = i * count / places;
}

}  // namespace thiessen
