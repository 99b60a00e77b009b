#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/inputs/inputs.h"
#include "gdal/output/encoded_file.h"
#include "gdal/rasters/raster_output.h"
#include "geometry/point_mapping.h"
#include "geometry/polygon.h"
#include "map/raster/surface_rows.h"
#include "map/sheet/rainfall_classes.h"
#include "rainfall/methods/rain_surface.h"
#include "rainfall/normals/normals_at_points.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The shapes of the study area, in the raster's coordinates.
std::vector<MultiPolygon> areas_of(const Inputs& inputs);

/// A mapping from the raster's coordinates to the study's, for use by one thread.
PointMapping to_study(const Inputs& inputs);

/// A mapping the other way.
PointMapping from_study(const Inputs& inputs);

/// The surface of readings, one for each station; with normals that of relative readings times the
/// normals of the month, or of the year. Requires one that reports.
std::unique_ptr<RainSurface> surface_in(const Inputs& inputs, std::span<const double> readings,
                                        SurfaceMethod method, const NormalMonth& month);
/// The normals at the points of the study, in a month or the year; null without.
std::shared_ptr<const NormalsAtPoints> normals_in(const Inputs& inputs, const NormalMonth& month);
/// The normals at the centres of a row of pixels; NaN where the projection ends.
std::vector<double> normals_in_row(const NormalsAtPoints& normals, const PixelGrid& grid, int row,
                                   const PointMapping& to_study);
/// The month that counts among those of normals: the year where they tell none apart.
NormalMonth month_among(const Inputs& inputs, const std::optional<std::size_t>& month);

/// Whether a place in the raster's coordinates lies among the gauges of a surface, which must
/// outlive it. For use by one thread.
std::function<bool(Point)> among_gauges_of(RainSurface& surface, PointMapping to_study);

/// The surface of readings at the centres of a raster's pixels. `inputs` and `readings` must
/// outlive it.
SurfaceRows surface_rows(const Inputs& inputs, std::span<const double> readings,
                         SurfaceMethod method, const NormalMonth& month, SurfaceRows::Beyond beyond,
                         const PixelGrid& grid, unsigned threads);

/// The pixels over the study area. `resolution` is a pixel's side; 0 gives the longer side 2,000
/// pixels. Throws Error where there would be too many.
PixelGrid raster_grid(const Inputs& inputs, double resolution);

/// What a raster shows.
struct ShownRaster {
  const GaugeReadings* readings = nullptr;  ///< none: the numbers of stations
  std::string time{};                       ///< of the readings; empty where they are means
  std::optional<SurfaceMethod> surface{};   ///< none: cells
  ClassRule classes{};                      ///< of its colours
};

/// The GeoTIFF `output.path` and its side files, of which one is a style for QGIS (`.qml`). A pixel
/// holds the number of the nearest station, or where there are readings the rainfall, of the cells
/// or of a surface. Warns of readings outside of a range of colours.
std::vector<EncodedFile> raster_of(const Inputs& inputs, const ShownRaster& shown,
                                   const RasterOutput& output, Warnings& warnings);

}  // namespace thiessen::cli
