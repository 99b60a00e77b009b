#include "study/coordinate_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "geometry/shape_points.h"

namespace thiessen {
namespace {

constexpr double farthest_longitude = 540;

bool is_well(Point at, double degrees_per_unit) {
  return std::abs(at.y * degrees_per_unit) <= 90 &&
         std::abs(at.x * degrees_per_unit) <= farthest_longitude;
}

/// Words the fault of a point that is known not to be longitude and latitude, such as `latitude
/// 132.5 of station 'A-03' is outside [-90, 90]`.
std::string fault_of(Point at, const std::string& whose, double degrees_per_unit) {
  if (!is_finite(at)) return "the position of " + whose + " has a coordinate that is no number";
  if (!(std::abs(at.y * degrees_per_unit) <= 90)) {
    return "latitude " + shortest_text(at.y) + " of " + whose + " is outside [-90, 90]";
  }
  return "longitude " + shortest_text(at.x) + " of " + whose + " is outside [-540, 540]";
}

/// Whether a point is out of range as it stands, and would be in range with its two coordinates
/// swapped.
bool looks_swapped(Point at, double degrees_per_unit) {
  return std::abs(at.y * degrees_per_unit) > 90 && std::abs(at.y * degrees_per_unit) <= 360 &&
         std::abs(at.x * degrees_per_unit) <= 90;
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

Reach reach_of(const StationList& stations) {
  Reach reach;
  for (const Station& station : stations.stations) reach.see(station.position);
  return reach;
}

Reach reach_of(const BasinList& basins) {
  Reach reach;
  for (const RawBasin& basin : basins.basins) {
    every_point(basin.polygons, [&](Point point) {
      reach.see(point);
      return true;
    });
  }
  return reach;
}

void require_degrees(const StationList& file, const CoordinateKind& kind,
                     const Wording& otherwise) {
  const double unit = kind.degrees_per_unit();
  const bool swapped =
      std::all_of(file.stations.begin(), file.stations.end(), [&](const Station& station) {
        return looks_swapped(station.position, unit) || is_well(station.position, unit);
      });
  Wording hint = !swapped         ? otherwise
                 : file.has_lines ? "columns look swapped: latitude and longitude"
                                  : "latitude and longitude look swapped";
  Complaints complaints;
  for (const Station& station : file.stations) {
    if (is_well(station.position, unit)) continue;
    const bool is_feature = !file.has_lines && station.line != 0;
    const std::string where = is_feature ? "feature " + std::to_string(station.line) + ": " : "";
    complaints.add({file.file, file.has_lines ? station.line : 0,
                    where + fault_of(station.position, "station " + quoted(station.id, 80), unit),
                    std::exchange(hint, Wording())});
  }
  complaints.throw_if_any();
}

void require_degrees(const BasinList& file, const CoordinateKind& kind, const Wording& otherwise) {
  const double unit = kind.degrees_per_unit();
  Wording left = otherwise;  // said once
  Complaints complaints;
  for (const RawBasin& basin : file.basins) {
    std::string text;
    bool swapped = true;
    every_point(basin.polygons, [&](Point point) {
      if (text.empty() && !is_well(point, unit)) text = fault_of(point, basin.place, unit);
      swapped = swapped && looks_swapped(point, unit);
      return true;
    });
    if (text.empty()) continue;
    Wording hint = swapped ? "latitude and longitude look swapped" : std::exchange(left, Wording());
    complaints.add({file.file, basin.line, std::move(text), std::move(hint)});
  }
  complaints.throw_if_any();
}

void turn_longitudes(StationList& file, const CoordinateKind& kind, Warnings& warnings) {
  const double unit = kind.degrees_per_unit();
  Message first;
  std::size_t turned = 0;
  for (Station& station : file.stations) {
    if (std::abs(station.position.x * unit) <= 180) continue;
    const double before = station.position.x;
    station.position.x = std::remainder(before * unit, 360) / unit;
    if (++turned > 1) continue;
    first = {file.file,
             file.has_lines ? station.line : 0,
             "longitude " + shortest_text(before) + " of station " + quoted(station.id, 80) +
                 " is taken for " + shortest_text(std::round(station.position.x * 1e9) / 1e9),
             {}};
  }
  if (turned == 0) return;
  if (turned > 1) {
    first.text += ", and " + std::to_string(turned - 1) +
                  (turned == 2 ? " other likewise" : " others likewise");
  }
  warnings.add(std::move(first));
}

void LongitudeRange::see(double longitude, const std::string& whose, const std::string& file,
                         std::size_t line) {
  if (!(longitude >= west_.longitude)) west_ = {longitude, whose, file, line};
  if (!(longitude <= east_.longitude)) east_ = {longitude, whose, file, line};
}

void LongitudeRange::require_one_turn() const {
  const bool eastern = east_.longitude > 180 && west_.longitude < 0;
  const bool western = west_.longitude < -180 && east_.longitude > 0;
  if (!eastern && !western) return;
  const auto text = [](const Extreme& e) { return shortest_text(e.longitude) + " of " + e.whose; };
  const Extreme& odd = eastern ? east_ : west_;
  throw Error(Message{odd.file, odd.line,
                      "longitude " + text(odd) + " beside " + text(eastern ? west_ : east_) +
                          ": planar distances do not go round the Earth",
                      "write all longitudes from -180 to 180, or all from 0 to 360"});
}

}  // namespace thiessen
