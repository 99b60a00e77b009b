#include "rainfall/network/network.h"

#include <cmath>
#include <utility>

#include "earth/nearest/one_place.h"
#include "geometry/equal_points.h"

namespace thiessen {
namespace {

// Gives all coordinates that mean the same point one form, so that they compare as equal.
Point canonical(Point p, Metric metric) {
  if (metric == Metric::geodesic) {
    if (p.x == -180) p.x = 180;
    if (std::abs(p.y) == 90) p.x = 0;
  }
  return {p.x + 0.0, p.y + 0.0};
}

// For each position the number of the station whose position is that of its place.
std::vector<std::uint32_t> stations_of_places(const std::vector<Point>& positions, Metric metric) {
  return metric == Metric::geodesic ? joined_positions(positions) : first_equal_points(positions);
}

}  // namespace

Network::Network(std::vector<Station> stations, Metric metric) : stations_(std::move(stations)) {
  std::vector<Point> positions;
  positions.reserve(stations_.size());
  for (const Station& station : stations_) positions.push_back(canonical(station.position, metric));
  const std::vector<std::uint32_t> place_at = stations_of_places(positions, metric);
  constexpr PlaceIndex none{0xFFFFFFFFu};
  std::vector<PlaceIndex> known(stations_.size(), none);
  place_of_.reserve(stations_.size());
  for (const std::uint32_t at : place_at) {
    if (known[at] == none) {
      known[at] = PlaceIndex{static_cast<std::uint32_t>(places_.size())};
      places_.push_back(positions[at]);
    }
    place_of_.push_back(known[at]);
  }
  first_at_.assign(places_.size() + 1, 0);
  for (const PlaceIndex place : place_of_) ++first_at_[index(place) + 1];
  for (std::size_t i = 1; i < first_at_.size(); ++i) first_at_[i] += first_at_[i - 1];
  by_place_.resize(stations_.size());
  std::vector<std::size_t> next(first_at_.begin(), first_at_.end() - 1);
  for (std::uint32_t i = 0; i < stations_.size(); ++i) {
    by_place_[next[index(place_of_[i])]++] = StationIndex{i};
  }
}

std::span<const StationIndex> Network::stations_at(PlaceIndex place) const {
  const std::size_t first = first_at_[index(place)];
  return std::span(by_place_).subspan(first, first_at_[index(place) + 1] - first);
}

}  // namespace thiessen
