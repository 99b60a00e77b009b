#include "study/given_lists.h"

#include <algorithm>
#include <string>
#include <unordered_set>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "geometry/shape_points.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_id = 80;

std::string named(const Station& station) {
  return "station " + quoted(station.id, longest_id);
}

/// Repeats the first point of a ring as its last, as rings in a file have it: an open ring would be
/// reported as a fault.
void close(Ring& ring) {
  if (!ring.empty() && ring.front() != ring.back()) ring.push_back(ring.front());
}

}  // namespace

StationList given_stations(std::vector<Station> stations) {
  Complaints complaints;
  if (stations.empty()) complaints.add({"", 0, "there are no stations", ""});
  std::unordered_set<std::string> ids;
  for (Station& station : stations) {
    if (station.id.empty()) complaints.add({"", 0, "a station has no id", ""});
    if (!station.id.empty() && !ids.insert(station.id).second)
      complaints.add({"", 0, named(station) + " is there twice", "ids must differ"});
    if (!is_finite(station.position))
      complaints.add({"", 0, named(station) + " has a coordinate that is not finite", ""});
    // Adding zero turns -0 into 0, so that both are the same place.
    station.position = {station.position.x + 0.0, station.position.y + 0.0};
    station.line = 0;
  }
  complaints.throw_if_any();
  return {"", std::move(stations), false};
}

BasinList given_basins(std::vector<Basin> basins) {
  BasinList list;
  Complaints complaints;
  std::unordered_set<std::string> ids;
  for (Basin& basin : basins) {
    const std::string place = "basin " + quoted(basin.id, longest_id);
    if (!ids.insert(basin.id).second)
      complaints.add(
          {"", 0, place + " is there twice", "parts of one basin are one basin's shape"});
    if (basin.shape.empty()) complaints.add({"", 0, place + " has an empty geometry", ""});
    if (!every_point(basin.shape, is_finite))
      complaints.add({"", 0, place + " has a coordinate that is not finite", ""});
    for (Polygon& polygon : basin.shape) {
      close(polygon.outer);
      std::for_each(polygon.holes.begin(), polygon.holes.end(), close);
    }
    list.basins.push_back({std::move(basin.id), place, 0, std::move(basin.shape)});
  }
  complaints.throw_if_any();
  return list;
}

}  // namespace thiessen
