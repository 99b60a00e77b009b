#include "io/coordinate_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr double farthest_longitude = 540;

/// `latitude 132.5 of station 'A-03' is outside [-90, 90]` and its hint; empty where the point is
/// well.
Message fault_of(Point at, const std::string& whose, double degrees_per_unit) {
  const double latitude = at.y * degrees_per_unit;
  const double longitude = at.x * degrees_per_unit;
  if (!(std::abs(latitude) <= 90)) {
    const bool swapped = std::abs(longitude) <= 90 && std::abs(latitude) <= 360;
    return {{},
            0,
            "latitude " + shortest_text(at.y) + " of " + whose + " is outside [-90, 90]",
            swapped ? "columns look swapped: latitude and longitude" : ""};
  }
  if (!(std::abs(longitude) <= farthest_longitude)) {
    return {
        {}, 0, "longitude " + shortest_text(at.x) + " of " + whose + " is outside [-540, 540]", {}};
  }
  return {};
}

/// Calls `see` with every point of the shape until it answers false.
template <typename See>
void each_point(const MultiPolygon& shape, See see) {
  const auto ring = [&](const Ring& points) {
    return std::all_of(points.begin(), points.end(), see);
  };
  for (const Polygon& polygon : shape) {
    if (!ring(polygon.outer) || !std::all_of(polygon.holes.begin(), polygon.holes.end(), ring))
      return;
  }
}

}  // namespace

void Reach::see(Point point) {
  west = points == 0 ? point.x : std::min(west, point.x);
  east = points == 0 ? point.x : std::max(east, point.x);
  south = points == 0 ? point.y : std::min(south, point.y);
  north = points == 0 ? point.y : std::max(north, point.y);
  ++points;
  if (std::abs(point.x) > 360 || std::abs(point.y) > 90) ++not_degrees;
}

std::string Reach::sentence() const {
  return "x from " + shortest_text(west) + " to " + shortest_text(east) + " and y from " +
         shortest_text(south) + " to " + shortest_text(north);
}

Reach reach_of(const StationsFile& stations) {
  Reach reach;
  for (const Station& station : stations.stations) reach.see(station.position);
  return reach;
}

Reach reach_of(const BasinsFile& basins) {
  Reach reach;
  for (const RawBasin& basin : basins.basins) {
    each_point(basin.polygons, [&](Point point) {
      reach.see(point);
      return true;
    });
  }
  return reach;
}

void require_fit(const Reach& reach, const Crs& crs, const std::string& file) {
  if (crs.geographic()) {
    const double degrees = crs.degrees_per_unit();
    const double nearest = std::min(std::max(std::abs(reach.west), std::abs(reach.east)),
                                    std::max(std::abs(reach.south), std::abs(reach.north)));
    if (reach.not_degrees == reach.points && nearest * degrees > farthest_longitude) {
      throw Error(Message{file, 0,
                          "coordinates are not degrees, as its CRS " + crs.name() +
                              " has them: " + reach.sentence(),
                          "name the CRS that they are in: --crs, --basins-crs"});
    }
    return;
  }
  const bool small = std::max(std::abs(reach.west), std::abs(reach.east)) <= 180 &&
                     std::max(std::abs(reach.south), std::abs(reach.north)) <= 90;
  if (small && crs.metres_per_unit() <= 1) {
    throw Error(Message{file, 0,
                        "coordinates look like degrees, but its CRS " + crs.name() +
                            " is projected: " + reach.sentence(),
                        "longitude and latitude are EPSG:4326"});
  }
}

void require_degrees(const StationsFile& file, const Crs& crs) {
  Complaints complaints;
  for (const Station& station : file.stations) {
    Message fault =
        fault_of(station.position, "station " + quoted(station.id, 80), crs.degrees_per_unit());
    if (fault.text.empty()) continue;
    fault.file = file.file;
    fault.line = file.has_lines ? station.line : 0;
    if (!file.has_lines) fault.text = "feature " + std::to_string(station.line) + ": " + fault.text;
    complaints.add(std::move(fault));
  }
  complaints.throw_if_any();
}

void require_degrees(const BasinsFile& file, const Crs& crs) {
  Complaints complaints;
  for (const RawBasin& basin : file.basins) {
    each_point(basin.polygons, [&](Point point) {
      Message fault = fault_of(point, basin.place, crs.degrees_per_unit());
      if (fault.text.empty()) return true;
      fault.file = file.file;
      fault.line = basin.line;
      complaints.add(std::move(fault));
      return false;
    });
  }
  complaints.throw_if_any();
}

void turn_longitudes(StationsFile& file, const Crs& crs, Warnings& warnings) {
  const double unit = crs.degrees_per_unit();
  std::size_t turned = 0;
  for (Station& station : file.stations) {
    const double longitude = station.position.x * unit;
    if (std::abs(longitude) <= 180) continue;
    station.position.x = std::remainder(longitude, 360) / unit;
    ++turned;
  }
  if (turned == 0) return;
  warnings.add({file.file,
                0,
                std::to_string(turned) + (turned == 1 ? " longitude" : " longitudes") +
                    " beyond 180 degrees taken round the Earth",
                {}});
}

}  // namespace thiessen
