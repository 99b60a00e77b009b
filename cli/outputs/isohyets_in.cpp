#include "cli/outputs/isohyets_in.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "cli/outputs/raster_of.h"
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

std::vector<double> levels_within(const SurfaceRaster& raster, const IsohyetLevels& wanted) {
  if (wanted.interval > 0) return isohyet_levels(raster.least, raster.largest, wanted.interval);
  std::vector<double> levels;
  for (const double level : wanted.levels) {
    if (level > raster.least && level < raster.largest) levels.push_back(level);
  }
  return levels;
}

}  // namespace

SurfaceRaster surface_raster(const Inputs& inputs, const GaugeReadings& readings,
                             SurfaceMethod method, SurfaceRows::Extent extent,
                             const RasterSize& size, unsigned threads) {
  SurfaceRaster raster;
  raster.grid = grid_for(inputs, size);
  SurfaceRows surface(
      raster.grid, extent,
      [&] {
        return surface_of(method, inputs.network(), inputs.study().metric, readings.readings);
      },
      [&] { return to_study(inputs); }, threads);
  const std::span<const float> values = surface.rows(0, raster.grid.rows, {});
  raster.values.assign(values.begin(), values.end());
  raster.least = HUGE_VAL;
  raster.largest = -HUGE_VAL;
  for (const float value : values) {
    if (std::isnan(value)) continue;
    raster.least = std::min<double>(raster.least, value);
    raster.largest = std::max<double>(raster.largest, value);
  }
  return raster;
}

std::vector<Isohyet> isohyets_in(const SurfaceRaster& raster, const IsohyetLevels& levels,
                                 std::span<const MultiPolygon> shapes) {
  return isohyets_of(raster.grid, raster.values, levels_within(raster, levels), shapes);
}

}  // namespace thiessen::cli
