#include "files/plane/plane_choice.h"

#include <cmath>

#include "base/number.h"
#include "gdal/crs/transformation.h"
#include "geometry/shape_points.h"

namespace thiessen {
namespace {

/// Appends the gauges that lie in their projection's area; the others are complained of later.
void append_gauges(const StationsFile& stations, const Crs& degrees, std::vector<Point>& all) {
  std::vector<Point> points;
  for (const Station& station : stations.stations) points.push_back(station.position);
  const std::vector<bool> inside = Transformation(*stations.crs, degrees).apply(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (inside[i]) all.push_back(points[i]);
  }
}

void append_vertices(std::span<const MultiPolygon> basins, const Crs& from, const Crs& degrees,
                     std::vector<Point>& all) {
  std::vector<Point> points;
  for (const MultiPolygon& shape : basins) {
    for (const Polygon& polygon : shape)
      points.insert(points.end(), polygon.outer.begin(), polygon.outer.end());
  }
  Transformation(from, degrees).apply_unproved(points);
  for (const Point p : points) {
    if (is_finite(p) && std::abs(p.y) <= 90) all.push_back(p);
  }
}

}  // namespace

std::string percent_text(double share) {
  constexpr double least = 1e-9;
  const double value = 100 * share;
  return (value > least ? significant_text(value, 2) : "0") + " %";
}

StudyPlane choose_plane(const StationsFile& stations, std::span<const MultiPolygon> basins,
                        const std::optional<Crs>& basins_crs, const Crs& degrees,
                        Warnings& warnings) {
  std::vector<Point> all;
  append_gauges(stations, degrees, all);
  if (basins_crs) append_vertices(basins, *basins_crs, degrees, all);
  if (all.empty()) {
    throw Error(Message{stations.file,
                        0,
                        "no station lies in the projection's area (" + stations.crs->name() + ")",
                        {}});
  }
  const auto fitted = fit_plane(all);
  if (!fitted || fitted->scale_error > largest_scale_error) {
    const std::string how =
        fitted ? ": lengths would be off by up to " + percent_text(fitted->scale_error) : "";
    throw Error(Message{{},
                        0,
                        "no plane suits gauges and basins that lie so far apart" + how,
                        setting("metric", "geodesic") + " measures the Earth as it is"});
  }
  warnings.add({{},
                0,
                "the plane is " + fitted->plane.proj_text() +
                    ", in which lengths are off by up to " + percent_text(fitted->scale_error),
                {}});
  return *fitted;
}

}  // namespace thiessen
