#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gdal/crs.h"
#include "gdal/encoded_file.h"
#include "geometry/pixel_grid.h"

namespace thiessen {

/// The owners of so many rows of a raster from `row` on, row by row from the north.
using OwnerRows = std::function<std::span<const std::int32_t>(int row, int count)>;

/// A GeoTIFF of the number (from 1) of each pixel's station, 0 outside, with a raster attribute
/// table of the ids, which GDAL keeps in a side file (`.aux.xml`): the first of the files is the
/// GeoTIFF, of the name `path`. `owners` is asked for 256 rows at a time, from the north.
/// Deflated, tiled; the bytes do not depend on `threads`. Throws Error where GDAL cannot write it,
/// Interrupted where a signal came. Memory: the file's.
std::vector<EncodedFile> owners_geotiff(const PixelGrid& grid, const OwnerRows& owners,
                                        const std::vector<std::string>& station_ids,
                                        const std::optional<Crs>& crs, const std::string& path,
                                        unsigned threads);

/// A GeoTIFF of the rainfall at each pixel, that of its owner, NaN (declared as "no data") outside.
/// `rainfall`: by station, from number 1 on.
std::vector<EncodedFile> rainfall_geotiff(const PixelGrid& grid, const OwnerRows& owners,
                                          std::span<const double> rainfall,
                                          const std::optional<Crs>& crs, const std::string& path,
                                          unsigned threads);

}  // namespace thiessen
