#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "gdal/output/encoded_file.h"
#include "gdal/rasters/raster_colours.h"
#include "gdal/rasters/raster_output.h"

namespace thiessen {

/// Gives the owners of the pixels of `count` rows of a raster from `row` on, row by row from the
/// north. An owner is a station's number, from 1 on; 0 stands for a pixel outside.
using OwnerRows = std::function<std::span<const std::int32_t>(int row, int count)>;

/// Gives the values of such pixels; NaN stands for a pixel outside.
using ValueRows = std::function<std::span<const float>(int row, int count)>;

/// Encodes a GeoTIFF of the number (from 1) of each pixel's station, 0 outside, with a raster
/// attribute table of the stations that own a pixel, with their colours where these are given. GDAL
/// keeps the table in a side file
/// (`.aux.xml`); the first of the files is the GeoTIFF, of the name `output.path`. `owners` is
/// asked for 256 rows at a time, from the north. The file says of itself what `output.made_by`
/// does, in TIFFTAG_SOFTWARE and GDAL's metadata. Throws Error where GDAL cannot write it, and
/// Interrupted where a signal came. Memory: 256 rows; in memory (see
/// RasterOutput) the file's size.
std::vector<EncodedFile> owners_geotiff(const RasterOutput& output, const OwnerRows& owners,
                                        const std::vector<std::string>& station_ids,
                                        const StationColours& colours = {});

/// Encodes a GeoTIFF of the rainfall at each pixel, NaN (declared as "no data") outside, with
/// a raster attribute table of the classes where there are any. The errors
/// and the order of rows are those of owners_geotiff.
std::vector<EncodedFile> rainfall_geotiff(const RasterOutput& output, const ValueRows& values,
                                          const BandText& text, const RasterClasses& classes = {});

}  // namespace thiessen
