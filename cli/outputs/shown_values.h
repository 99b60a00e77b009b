#pragma once

#include <vector>

#include "cli/inputs/inputs.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The readings of the gauges that have ground in a basin, once each: those by which a picture's
/// classes are laid. With normals they are the means of the cells in each basin. Cost: that of
/// weights.
std::vector<double> shown_values(const Inputs& inputs, const GaugeReadings& readings,
                                 unsigned threads);

}  // namespace thiessen::cli
