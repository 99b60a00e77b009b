#include "files/places/datums.h"
#include "gdal/crs/transformation.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/number.h"
#include "base/utf8.h"
#include "rainfall/network/extent.h"

namespace thiessen {
namespace {

// Metres. Reference frames that are taken for WGS 84, such as NAD 83 and GDA 94, have accuracies of
// 1 to 4 m in EPSG's tables, and are no reason to warn.
constexpr double well_enough = 5;
constexpr double not_stated = 999;  // EPSG writes this figure where it states no accuracy

std::vector<Point> corners_of(const StationsFile& file) {
  std::vector<Point> corners;
  for (const Station& station : file.stations) corners.push_back(station.position);
  return corners;
}

std::vector<Point> corners_of(const BasinsFile& file) {
  std::vector<Point> corners;
  for (const RawBasin& basin : file.basins) {
    for (const Polygon& polygon : basin.polygons) {
      Box box;
      for (const Point point : polygon.outer) box.take_in(point);
      corners.insert(corners.end(),
                     {box.low, {box.low.x, box.high.y}, box.high, {box.high.x, box.low.y}});
    }
  }
  return corners;
}

/// Adds points around each station, or around the corners of each polygon's box, in degrees of WGS
/// 84.
template <typename File>
void take_in(const File& file, std::vector<Point>& reached) {
  if (!file.crs) return;
  std::vector<Point> points = corners_of(file);
  if (!take_roughly_to_degrees(*file.crs, points)) return;
  constexpr double datums_apart = 0.01;
  for (const Point p : points) {
    if (!(std::abs(p.x) <= 540 && std::abs(p.y) <= 90)) continue;
    const double x = std::remainder(p.x, 360);
    reached.push_back({x - datums_apart, p.y - datums_apart});
    reached.push_back({x + datums_apart, p.y + datums_apart});
  }
}

std::optional<Box> area_of(const StationsFile& stations, const BasinsFile* basins) {
  std::vector<Point> reached;
  take_in(stations, reached);
  if (basins != nullptr) take_in(*basins, reached);
  const auto extent = reached.empty() ? std::nullopt : extent_of(reached, Metric::geodesic, 0);
  if (!extent) return std::nullopt;
  Box box;
  for (const Point point : extent->shape[0].outer) box.take_in(point);
  if (box.width() >= 360) return std::nullopt;
  return box;
}

/// A warning of what is odd about the operation between two CRSs; its text is empty where nothing
/// is.
Message doubt_of(const Crs& from, const Crs& to) {
  const Transformation transformation(from, to);
  if (transformation.identity()) return {};
  const OperationChoice& choice = *transformation.choice();
  if (!choice.sphere.empty()) {
    const std::string& other = choice.sphere == from.name() ? to.name() : from.name();
    return {{},
            0,
            choice.sphere +
                " is a sphere without a datum: its longitudes and latitudes are taken "
                "for " +
                other + "'s",
            "models of the atmosphere mean them so"};
  }
  if (!choice.accuracy || *choice.accuracy <= well_enough) return {};
  const std::string how = *choice.accuracy < not_stated
                              ? " to within " + shortest_text(*choice.accuracy) + " m only"
                              : " with an accuracy that nobody states";
  const std::string grid = better_grid(from, to, from.area(), *choice.accuracy);
  return {{},
          0,
          from.name() + " is taken to " + to.name() + how + ", by " + quoted(choice.name, 200),
          grid.empty() ? "" : "PROJ would be more accurate with its grid " + quoted(grid, 80)};
}

/// A warning of what is odd about the operation that takes the file's coordinates into the study's.
template <typename File>
Message doubt_of(const File& file, const Crs& study) {
  if (!file.crs) return {};
  try {
    Message doubt = doubt_of(*file.crs, study);
    doubt.file = file.file;
    return doubt;
  } catch (const Error& error) {
    Message message = error.messages().at(0);
    if (message.file.empty()) message.file = file.file;
    throw Error(std::move(message));
  }
}

}  // namespace

void settle_datums(StationsFile& stations, BasinsFile* basins, std::optional<Crs>& study,
                   Warnings& warnings) {
  if (!study) return;
  if (const auto area = area_of(stations, basins)) {
    study = study->over(*area);
    if (stations.crs) stations.crs = stations.crs->over(*area);
    if (basins != nullptr && basins->crs) basins->crs = basins->crs->over(*area);
  }
  const Message first = doubt_of(stations, *study);
  if (!first.text.empty()) warnings.add(first);
  if (basins == nullptr) return;
  const Message second = doubt_of(*basins, *study);
  if (!second.text.empty() && second.text != first.text) warnings.add(second);
}

}  // namespace thiessen
