#include "files/places/met_stations.h"

#include <algorithm>
#include <bit>
#include <functional>

#include "geometry/hash_mixing.h"

namespace thiessen {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;
constexpr std::size_t smallest_table = 64;

std::uint64_t hash_of(std::string_view id) {
  return mixed_bits(std::hash<std::string_view>()(id));
}

std::uint32_t tag_of(std::uint64_t hash) {
  return static_cast<std::uint32_t>(hash >> 32);
}

bool is_beyond(std::string_view id, std::string_view other) {
  return id.size() != other.size() ? id.size() > other.size() : id > other;
}

}  // namespace

const Station* MetStations::meet(std::string_view id) {
  if (table_.empty() && (stations_.empty() || is_beyond(id, stations_.back().id))) return nullptr;
  if (2 * stations_.size() >= table_.size()) grow();
  const std::uint64_t hash = hash_of(id);
  Entry& entry = entry_of(id, hash);
  if (entry.station != none) return &stations_[entry.station];
  entry = {static_cast<std::uint32_t>(stations_.size()), tag_of(hash)};
  return nullptr;
}

MetStations::Entry& MetStations::entry_of(std::string_view id, std::uint64_t hash) {
  const std::size_t mask = table_.size() - 1;
  const auto is_other = [&](const Entry& entry) {
    return entry.station != none &&
           (entry.tag != tag_of(hash) || stations_[entry.station].id != id);
  };
  std::size_t place = hash & mask;
  while (is_other(table_[place])) place = (place + 1) & mask;
  return table_[place];
}

void MetStations::grow() {
  table_.assign(std::bit_ceil(std::max(smallest_table, 4 * stations_.size())), {none, 0});
  for (std::uint32_t i = 0; i < stations_.size(); ++i) {
    const std::uint64_t hash = hash_of(stations_[i].id);
    entry_of(stations_[i].id, hash) = {i, tag_of(hash)};
  }
}

}  // namespace thiessen
