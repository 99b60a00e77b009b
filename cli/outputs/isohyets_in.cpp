#include "cli/outputs/isohyets_in.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/error.h"
#include "cli/outputs/raster_of.h"
#include "map/raster/surface_rows.h"
#include "rainfall/methods/isohyets.h"

namespace thiessen::cli {
namespace {

constexpr int default_pixels = 1000;

/// Lines end at pixels' centres, so that the raster reaches beyond the basins.
PixelGrid widened(PixelGrid grid) {
  constexpr int margin = 2;
  grid.north_west = grid.at(-margin, -margin);
  grid.columns += 2 * margin;
  grid.rows += 2 * margin;
  return grid;
}

PixelGrid grid_for(const Inputs& inputs, double resolution) {
  if (resolution > 0) return widened(raster_grid(inputs, resolution));
  const PixelGrid fine = raster_grid(inputs, 0);
  return widened(
      raster_grid(inputs, fine.pixel * std::max(fine.columns, fine.rows) / default_pixels));
}

std::vector<double> levels_of(std::span<const float> values, const IsohyetOptions& options) {
  double least = std::numeric_limits<double>::infinity();
  double largest = -least;
  for (const float value : values) {
    if (std::isnan(value)) continue;
    least = std::min(least, static_cast<double>(value));
    largest = std::max(largest, static_cast<double>(value));
  }
  if (options.breaks.empty()) {
    try {
      return isohyet_levels(least, largest, options.interval);
    } catch (const std::length_error&) {
      throw Error({"", 0, "there would be more than 10000 isohyets",
                   "a larger " + setting("interval") + " makes fewer"});
    }
  }
  std::vector<double> levels;
  for (const double level : options.breaks) {
    if (level > least && level < largest) levels.push_back(level);
  }
  return levels;
}

}  // namespace

std::vector<Isohyet> isohyets_in(const Inputs& inputs, const GaugeReadings& readings,
                                 const IsohyetOptions& options, double resolution,
                                 unsigned threads) {
  if (!readings.reports().any()) return {};
  const PixelGrid grid = grid_for(inputs, resolution);
  SurfaceRows surface(
      grid, SurfaceRows::Extent::among_gauges,
      [&] {
        return surface_of(*options.surface(), inputs.network(), inputs.study().metric,
                          readings.readings);
      },
      [&] { return to_study(inputs); }, threads);
  const std::span<const float> values = surface.rows(0, grid.rows, {});
  return isohyets_of(grid, values, levels_of(values, options), areas_of(inputs));
}

}  // namespace thiessen::cli
