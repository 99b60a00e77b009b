#include "cli/outputs/rasters/isohyets_in.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "base/error.h"
#include "base/interrupt.h"
#include "cli/outputs/rasters/raster_of.h"
#include "geometry/point_mapping.h"
#include "rainfall/methods/isohyets.h"

namespace thiessen::cli {
namespace {

PixelGrid widened(PixelGrid grid) {
  constexpr int margin = 2;
  grid.north_west = grid.at(-margin, -margin);
  grid.columns += 2 * margin;
  grid.rows += 2 * margin;
  return grid;
}

PixelGrid grid_for(const Inputs& inputs, const RasterSize& size) {
  if (size.resolution > 0) return widened(raster_grid(inputs, size.resolution));
  const PixelGrid fine = raster_grid(inputs, 0);
  return widened(raster_grid(inputs, fine.pixel * std::max(fine.columns, fine.rows) / size.pixels));
}

std::vector<double> levels_within(const ValueRange& range, const IsohyetLevels& wanted) {
  if (wanted.interval > 0) return isohyet_levels(range.least, range.largest, wanted.interval);
  std::vector<double> levels;
  for (const double level : wanted.levels) {
    if (level > range.least && level < range.largest) levels.push_back(level);
  }
  return levels;
}

/// Cuts off what lies beyond the gauges, and leaves out isohyets of which nothing is left.
void keep_among_gauges(std::vector<Isohyet>& isohyets,
                       const std::function<bool(Point)>& is_among_gauges) {
  for (Isohyet& isohyet : isohyets) {
    throw_if_interrupted();
    std::vector<std::vector<Point>> kept;
    for (const std::vector<Point>& line : isohyet.lines) {
      for (std::vector<Point>& part : parts_where(line, is_among_gauges))
        kept.push_back(std::move(part));
    }
    isohyet.lines = std::move(kept);
  }
  std::erase_if(isohyets, [](const Isohyet& isohyet) { return isohyet.lines.empty(); });
}

}  // namespace

SurfaceRaster surface_raster(const Inputs& inputs, const GaugeReadings& readings,
                             SurfaceMethod method, SurfaceRows::Beyond beyond,
                             const RasterSize& size, unsigned threads) {
  SurfaceRaster raster;
  raster.grid = grid_for(inputs, size);
  SurfaceRows surface =
      surface_rows(inputs, readings.readings, method, month_among(inputs, readings.month), beyond,
                   raster.grid, threads);
  const std::span<const float> values = surface.rows(0, raster.grid.rows, {});
  raster.values.assign(values.begin(), values.end());
  const std::span<const std::uint8_t> among_gauges = surface.are_among_gauges();
  raster.is_among_gauges.assign(among_gauges.begin(), among_gauges.end());
  raster.range = surface.range_among_gauges();
  return raster;
}

std::vector<Isohyet> isohyets_on(const SurfaceRaster& raster, const Inputs& inputs,
                                 const GaugeReadings& readings, SurfaceMethod method,
                                 const IsohyetLevels& levels,
                                 std::span<const MultiPolygon> shapes) {
  if (!raster.range) return {};
  std::vector<Isohyet> isohyets =
      isohyets_of(raster.grid, raster.values, levels_within(*raster.range, levels), shapes);
  if (isohyets.empty()) return isohyets;
  const auto surface =
      surface_in(inputs, readings.readings, method, month_among(inputs, readings.month));
  keep_among_gauges(isohyets, among_gauges_of(*surface, to_study(inputs)));
  return isohyets;
}

std::vector<Isohyet> isohyets_in(const Inputs& inputs, const GaugeReadings& readings,
                                 SurfaceMethod method, const RasterSize& size,
                                 const IsohyetLevels& levels, std::span<const MultiPolygon> shapes,
                                 unsigned threads) {
  if (!readings.reports().any()) return {};
  return isohyets_on(
      surface_raster(inputs, readings, method, SurfaceRows::Beyond::continued, size, threads),
      inputs, readings, method, levels, shapes);
}

}  // namespace thiessen::cli
