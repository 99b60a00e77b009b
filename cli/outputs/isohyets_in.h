#pragma once

#include <vector>

#include "cli/inputs/inputs.h"
#include "cli/options/isohyet_options.h"
#include "gdal/output/isohyet_lines.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The isohyets of the readings in the basins, by basin and level. They are drawn on a raster over
/// the basins and a little beyond, whose pixel is `resolution`; 0 gives the longer side 1,000
/// pixels. None where no gauge reports. Throws Error where there would be too many levels.
std::vector<Isohyet> isohyets_in(const Inputs& inputs, const GaugeReadings& readings,
                                 const IsohyetOptions& options, double resolution,
                                 unsigned threads);

}  // namespace thiessen::cli
