#pragma once

#include <string>
#include <vector>

#include "cli/inputs.h"
#include "files/cells_file.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The GeoTIFF `path` and its side files: of each pixel the number of the nearest station, or the
/// rainfall where there are readings. `resolution` 0: the longer side in 2,000 pixels. Throws Error
/// where the raster would be too large.
std::vector<EncodedFile> raster_of(const Inputs& inputs, const GaugeReadings* readings,
                                   double resolution, const std::string& path, unsigned threads);

}  // namespace thiessen::cli
