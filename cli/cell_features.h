#pragma once

#include <string>
#include <vector>

#include "cli/inputs.h"
#include "files/cells_file.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The cells of the gauges that report (all of them without readings), by basin.
std::vector<std::vector<StationCell>> cells_of(const Inputs& inputs, const GaugeReadings* readings,
                                               unsigned threads);

/// The same, as they are written.
CellsOutput cells_output(const Inputs& inputs, const std::vector<std::vector<StationCell>>& cells,
                         const GaugeReadings* readings, const StudyOptions& options);

/// Says so where the cells are not in longitude and latitude, because no CRS is known. `file`:
/// where they go.
void warn_of_own_coordinates(const Inputs& inputs, const std::string& file, Warnings& warnings);

}  // namespace thiessen::cli
