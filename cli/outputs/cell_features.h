#pragma once

#include <string>
#include <vector>

#include "cli/inputs/inputs.h"
#include "files/cells_file.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The cells of the gauges that report, for each basin; without `readings` all gauges report.
std::vector<std::vector<StationCell>> cells_of(const Inputs& inputs, const GaugeReadings* readings,
                                               unsigned threads);

/// The cells of the whole network, for each basin.
std::vector<std::vector<StationCell>> cells_of_network(const Inputs& inputs, unsigned threads);

/// Prepares the cells to be written, with their weights, the rainfall of `readings` if there are
/// any, and the stations' attributes if the options ask for them. `unit` is that of the readings.
CellsOutput cells_output(const Inputs& inputs, std::vector<std::vector<StationCell>> cells,
                         const GaugeReadings* readings, const StudyOptions& options,
                         const std::string& unit);

/// The same cells, one at a time; cells_output without cells tells what they have in common. All
/// that is given has to outlive the source.
CellSource cell_source(const Inputs& inputs, const GaugeReadings* readings, unsigned threads);

/// Warns where no CRS is known, so that the cells are not in longitude and latitude. `file` is the
/// file to which they are written.
void warn_of_own_coordinates(const Inputs& inputs, const std::string& file, Warnings& warnings);

}  // namespace thiessen::cli
