#pragma once

#include <string>

#include "cli/inputs/inputs.h"
#include "rainfall/series/gauge_readings.h"
#include "results/provenance.h"

namespace thiessen::cli {

/// What an output of these inputs says of how it was made. `readings` are what it shows, in
/// `unit`; null where it shows no rainfall.
Provenance provenance_of(const Inputs& inputs, const StudyOptions& options,
                         const GaugeReadings* readings, const std::string& unit);

}  // namespace thiessen::cli
