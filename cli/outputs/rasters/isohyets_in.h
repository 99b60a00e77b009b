#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cli/inputs/inputs.h"
#include "gdal/output/isohyet_lines.h"
#include "geometry/pixel_grid.h"
#include "geometry/polygon.h"
#include "map/raster/surface_rows.h"
#include "rainfall/methods/isohyets.h"
#include "rainfall/methods/rain_surface.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The levels at which isohyets are drawn: multiples of an interval or, where that is 0, these.
struct IsohyetLevels {
  double interval = 0;
  std::vector<double> levels;
};

/// A surface's values on a raster over the study area and a little beyond, for lines end at pixels'
/// centres.
struct SurfaceRaster {
  PixelGrid grid;
  std::vector<float> values;
  std::vector<std::uint8_t> is_among_gauges;  ///< by pixel
  /// Of the values among the gauges; nothing where there are none.
  std::optional<ValueRange> range;
};

/// The raster of the readings' surface, whose pixel is `resolution`; 0 gives the longer side
/// `pixels`. Requires a gauge that reports.
struct RasterSize {
  double resolution = 0;
  int pixels = 1000;
};
SurfaceRaster surface_raster(const Inputs& inputs, const GaugeReadings& readings,
                             SurfaceMethod method, SurfaceRows::Beyond beyond,
                             const RasterSize& size, unsigned threads);

/// The isohyets of the readings' surface in the shapes, by shape and level, at the levels strictly
/// between its least and its largest value on a raster of this size. They end on the gauges' hull:
/// the jump beyond it is not drawn. None where no gauge reports. Throws Error where there would be
/// too many.
std::vector<Isohyet> isohyets_in(const Inputs& inputs, const GaugeReadings& readings,
                                 SurfaceMethod method, const RasterSize& size,
                                 const IsohyetLevels& levels, std::span<const MultiPolygon> shapes,
                                 unsigned threads);

/// The same on a raster of the surface that is there, continued beyond the gauges.
std::vector<Isohyet> isohyets_on(const SurfaceRaster& raster, const Inputs& inputs,
                                 const GaugeReadings& readings, SurfaceMethod method,
                                 const IsohyetLevels& levels, std::span<const MultiPolygon> shapes);

}  // namespace thiessen::cli
