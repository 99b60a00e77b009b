#include "cli/raster_of.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "base/number.h"
#include "geometry/ring_location.h"
#include "io/crs.h"
#include "io/raster_file.h"
#include "map/owners.h"

namespace thiessen::cli {
namespace {

constexpr double default_pixels = 2000;
constexpr double largest_side = 100'000;
constexpr double most_pixels = 400e6;

/// The study area in the raster's coordinates.
std::vector<MultiPolygon> areas_of(const Session& session) {
  const Study& study = session.study();
  if (session.has_basins()) return study.native_basins;
  std::vector<MultiPolygon> areas;
  for (const Basin& basin : study.basins) areas.push_back(basin.shape);
  const auto& to = study.output_crs();
  if (!study.crs || !to || study.crs->same_as(*to)) return areas;
  // The extent's edges are curves there: they are followed in small steps.
  const Transformation transformation(*study.crs, *to);
  constexpr int steps = 100;
  for (MultiPolygon& area : areas) {
    for (Polygon& part : area) {
      Ring fine;
      for (std::size_t i = 0; i < part.outer.size(); ++i) {
        const Point a = part.outer[i];
        const Point b = part.outer[(i + 1) % part.outer.size()];
        for (int s = 0; s < steps; ++s) {
          const double share = static_cast<double>(s) / steps;
          fine.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
        }
      }
      transformation.apply_unproved(fine);
      std::erase_if(fine, [](Point p) { return !std::isfinite(p.x) || !std::isfinite(p.y); });
      part.outer = std::move(fine);
    }
  }
  return areas;
}

/// The multiple of `step` at or beyond `value`, downward or upward; a multiple stays, whatever
/// rounding does.
double snapped(double value, double step, double (*towards)(double)) {
  const double nearest = std::round(value / step);
  return (nearest * step == value ? nearest : towards(value / step)) * step;
}

PixelGrid grid_of(const std::vector<MultiPolygon>& areas, double resolution) {
  Box box;
  for (const MultiPolygon& area : areas) {
    for (const Polygon& part : area) box.take_in(box_of(part.outer));
  }
  PixelGrid grid;
  grid.pixel = resolution > 0 ? resolution : std::max(box.width(), box.height()) / default_pixels;
  const double west = snapped(box.low.x, grid.pixel, std::floor);
  const double north = snapped(box.high.y, grid.pixel, std::ceil);
  const double columns =
      std::max(1.0, std::round((snapped(box.high.x, grid.pixel, std::ceil) - west) / grid.pixel));
  const double rows =
      std::max(1.0, std::round((north - snapped(box.low.y, grid.pixel, std::floor)) / grid.pixel));
  if (!(columns <= largest_side && rows <= largest_side && columns * rows <= most_pixels)) {
    throw Error({"", 0,
                 "the raster would have " + fixed_text(columns, 0) + " x " + fixed_text(rows, 0) +
                     " pixels; the most are 400 million, and 100000 on a side",
                 "a larger --resolution makes it smaller"});
  }
  grid.north_west = {west, north};
  grid.columns = static_cast<int>(columns);
  grid.rows = static_cast<int>(rows);
  return grid;
}

ToStudy transformation_to_study(const Study& study) {
  const auto& from = study.output_crs();
  if (!from || !study.crs || from->same_as(*study.crs)) return [](std::vector<Point>&) {};
  const auto transformation = std::make_shared<Transformation>(*from, *study.crs);
  return [transformation](std::vector<Point>& points) { transformation->apply_unproved(points); };
}

}  // namespace

std::vector<EncodedFile> raster_of(const Session& session, const GaugeReadings* readings,
                                   double resolution, const std::string& path, unsigned threads) {
  const Study& study = session.study();
  const std::vector<MultiPolygon> areas = areas_of(session);
  const PixelGrid grid = grid_of(areas, resolution);
  const std::vector<bool> reports =
      readings == nullptr ? session.all_report() : readings->reports();
  std::vector<std::int32_t> numbers(
      static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), 0);
  if (std::find(reports.begin(), reports.end(), true) != reports.end()) {
    numbers = owners(
        grid, areas, session.network(), study.metric, reports,
        [&] { return transformation_to_study(study); }, threads);
  }
  if (readings == nullptr) {
    std::vector<std::string> ids;
    for (const Station& station : session.network().stations()) ids.push_back(station.id);
    return owners_geotiff(grid, numbers, ids, study.output_crs(), path);
  }
  std::vector<float> rainfall;
  rainfall.reserve(numbers.size());
  for (const std::int32_t number : numbers) {
    rainfall.push_back(
        number == 0 ? std::numeric_limits<float>::quiet_NaN()
                    : static_cast<float>(readings->readings[static_cast<std::size_t>(number) - 1]));
  }
  return rainfall_geotiff(grid, rainfall, study.output_crs(), path);
}

}  // namespace thiessen::cli
