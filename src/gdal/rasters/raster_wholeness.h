#pragma once

#include <string>
#include <vector>

class GDALDataset;

namespace thiessen {

/// Requires that what a raster's header promises is there, before GDAL reads what is there of it:
/// of some formats it reads zeros beyond a file's end, and says nothing. Raw pixels, blocks of a
/// GeoTIFF, classic NetCDF and PCRaster are held against the length of their files; grids of text
/// are read once through, line after line; files of which a virtual raster is made are held to the
/// same. `file` is the raster's name in messages. Throws Error, and Interrupted where a signal
/// came. Cost: that of reading a grid of text; else a look at each block or file.
void require_whole_raster(const std::string& file, GDALDataset& dataset);

/// The files of a raster that are texts of lines: its header's, or the grid itself.
std::vector<std::string> texts_of_raster(GDALDataset& dataset);

}  // namespace thiessen
