#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gdal/crs/crs.h"
#include "gdal/output/encoded_file.h"
#include "geometry/pixel_grid.h"
#include "results/provenance.h"

namespace thiessen {

/// Gives the owners of the pixels of `count` rows of a raster from `row` on, row by row from the
/// north. An owner is a station's number, from 1 on; 0 stands for a pixel outside.
using OwnerRows = std::function<std::span<const std::int32_t>(int row, int count)>;

/// Encodes a GeoTIFF of the number (from 1) of each pixel's station, 0 outside, with a raster
/// attribute table of the ids. GDAL keeps the table in a side file (`.aux.xml`); the first of the
/// files is the GeoTIFF, of the name `path`. `owners` is asked for 256 rows at a time, from the
/// north. The file says of itself what `made_by` does, in TIFFTAG_SOFTWARE and GDAL's metadata. It
/// is deflated and tiled, and its bytes do not depend on `threads`. Throws Error where GDAL cannot
/// write it, and Interrupted where a signal came. Memory: the file's size.
std::vector<EncodedFile> owners_geotiff(const PixelGrid& grid, const OwnerRows& owners,
                                        const std::vector<std::string>& station_ids,
                                        const std::optional<Crs>& crs, const Provenance& made_by,
                                        const std::string& path, unsigned threads);

/// Encodes a GeoTIFF of the rainfall at each pixel: that of the pixel's owner, and NaN (declared as
/// "no data") outside. `rainfall` is by station, from number 1 on. The errors and the order of rows
/// are those of owners_geotiff.
std::vector<EncodedFile> rainfall_geotiff(const PixelGrid& grid, const OwnerRows& owners,
                                          std::span<const double> rainfall,
                                          const std::optional<Crs>& crs, const Provenance& made_by,
                                          const std::string& path, unsigned threads);

}  // namespace thiessen
