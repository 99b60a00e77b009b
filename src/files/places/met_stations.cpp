#include "files/places/met_stations.h"

#include <algorithm>
#include <functional>

#include "geometry/hash_mixing.h"

namespace thiessen {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;
constexpr std::size_t smallest_table = 64;

}  // namespace

const Station* MetStations::meet(const Station& station) {
  if (2 * stations_.size() >= table_.size()) grow();
  std::uint32_t& at = table_[place_of(station.id)];
  if (at != none) return &stations_[at];
  at = static_cast<std::uint32_t>(stations_.size());
  stations_.push_back(station);
  return nullptr;
}

std::size_t MetStations::place_of(std::string_view id) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t place = mixed_bits(std::hash<std::string_view>()(id)) & mask;
  while (table_[place] != none && stations_[table_[place]].id != id) place = (place + 1) & mask;
  return place;
}

void MetStations::grow() {
  table_.assign(std::max(smallest_table, 4 * stations_.size()), none);
  for (std::uint32_t i = 0; i < stations_.size(); ++i) table_[place_of(stations_[i].id)] = i;
}

}  // namespace thiessen
