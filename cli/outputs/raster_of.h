#pragma once

#include <string>
#include <vector>

#include "cli/inputs/inputs.h"
#include "files/cells_file.h"
#include "rainfall/series/gauge_readings.h"
#include "results/provenance.h"

namespace thiessen::cli {

/// The GeoTIFF `path` and its side files. A pixel holds the number of the nearest station, or where
/// there are readings the rainfall. `resolution` is the pixel's side; 0 gives the longer side 2,000
/// pixels. Throws Error where the raster would be too large.
std::vector<EncodedFile> raster_of(const Inputs& inputs, const GaugeReadings* readings,
                                   double resolution, const Provenance& made_by,
                                   const std::string& path, unsigned threads);

}  // namespace thiessen::cli
