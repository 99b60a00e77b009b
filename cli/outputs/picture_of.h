#pragma once

#include <vector>

#include "cli/inputs/inputs.h"
#include "cli/options/blocks/view_options.h"
#include "map/sheet/picture.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The picture of the cells: by rainfall where there are readings, else by station.
Picture picture_of(const Inputs& inputs, const std::vector<std::vector<StationCell>>& cells,
                   const GaugeReadings* readings, const StudyOptions& options,
                   const ViewOptions& view);

}  // namespace thiessen::cli
