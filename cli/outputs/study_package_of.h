#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/inputs/inputs.h"
#include "files/study_package.h"
#include "map/sheet/rainfall_classes.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// What a study in one file is made of beside its cells.
struct PackageParts {
  const GaugeReadings* readings = nullptr;  ///< null where there is no rainfall
  const std::vector<BasinWeights>* weights = nullptr;
  std::optional<RainfallClasses> classes{};  ///< of the colours, where there is rainfall
  std::string unit{};
  double interval = 0;  ///< between isohyets; 0: none are wanted
  unsigned threads = 1;
};

/// Gathers a study into one file: its cells, all its gauges, those that never report among them,
/// its basins with their areas, and weights. Isohyets are of natural neighbours.
StudyPackage study_package_of(const Inputs& inputs, CellsOutput cells, const PackageParts& parts);

}  // namespace thiessen::cli
