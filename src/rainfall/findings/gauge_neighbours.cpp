#include "rainfall/findings/gauge_neighbours.h"

#include <algorithm>
#include <set>
#include <utility>

namespace thiessen {
namespace {

constexpr std::size_t most_of_a_place = 4;

std::span<const StationIndex> that_stand_for(const Network& network, PlaceIndex place) {
  const auto all = network.stations_at(place);
  return all.first(std::min(all.size(), most_of_a_place));
}

/// The gauges with which those at a place are compared, by place.
std::vector<std::vector<StationIndex>> compared_with(const Network& network,
                                                     std::span<const StationBorder> borders) {
  std::vector<std::vector<StationIndex>> found(network.places().size());
  const auto add = [&](PlaceIndex to, PlaceIndex from) {
    const auto gauges = that_stand_for(network, from);
    std::vector<StationIndex>& of_place = found[index(to)];
    of_place.insert(of_place.end(), gauges.begin(), gauges.end());
  };
  for (std::uint32_t p = 0; p < network.places().size(); ++p) {
    if (network.stations_at(PlaceIndex{p}).size() > 1) add(PlaceIndex{p}, PlaceIndex{p});
  }
  for (const StationBorder& border : borders) {
    const PlaceIndex a = network.place_of(border.station);
    const PlaceIndex b = network.place_of(border.neighbour);
    add(a, b);
    add(b, a);
  }
  return found;
}

}  // namespace

GaugeNeighbours::GaugeNeighbours(const Network& network, std::span<const StationBorder> borders) {
  const auto by_place = compared_with(network, borders);
  const auto count = static_cast<std::uint32_t>(network.stations().size());
  std::set<std::pair<StationIndex, StationIndex>> pairs;
  for (std::uint32_t g = 0; g < count; ++g) {
    for (const StationIndex n : by_place[index(network.place_of(StationIndex{g}))]) {
      if (n != StationIndex{g}) pairs.insert(std::minmax(n, StationIndex{g}));
    }
  }
  for (const auto& [first, second] : pairs) pairs_.push_back({first, second});
  const auto pair_of = [&](StationIndex a, StationIndex b) {
    const auto [first, second] = std::minmax(a, b);
    const auto at = std::lower_bound(pairs_.begin(), pairs_.end(), std::pair(first, second),
                                     [](const Pair& pair, const auto& wanted) {
                                       return std::pair(pair.first, pair.second) < wanted;
                                     });
    return static_cast<std::uint32_t>(at - pairs_.begin());
  };
  begins_.push_back(0);
  for (std::uint32_t g = 0; g < count; ++g) {
    const StationIndex gauge{g};
    std::vector<StationIndex> others = by_place[index(network.place_of(gauge))];
    std::sort(others.begin(), others.end());
    for (const StationIndex n : others) {
      if (n != gauge) neighbours_.push_back({n, pair_of(gauge, n), n < gauge});
    }
    begins_.push_back(neighbours_.size());
  }
}

}  // namespace thiessen
