#include "readings/readings_stations.h"

#include "base/utf8.h"

namespace thiessen {

ReadingsStations::ReadingsStations(std::span<const Station> stations,
                                   std::span<const std::string> passed_over)
    : stations_(stations) {
  by_id_.reserve(stations.size() + passed_over.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    by_id_.emplace(stations[i].id,
                   Found{Standing::known, StationIndex{static_cast<std::uint32_t>(i)}});
  }
  for (const std::string& id : passed_over) by_id_.emplace(id, Found{Standing::passed_over, {}});
}

ReadingsStations::Found ReadingsStations::find(std::string_view text) const {
  auto found = by_id_.find(text);
  if (found == by_id_.end()) found = by_id_.find(trimmed(text));
  return found == by_id_.end() ? Found{} : found->second;
}

}  // namespace thiessen
