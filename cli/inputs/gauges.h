#pragma once

#include <optional>

#include "cli/inputs/inputs.h"
#include "rainfall/series/gauge_readings.h"

namespace thiessen::cli {

/// The readings that cells and pictures show: the step at `time`, or the means where no time is
/// given; none without RAINFALL. Throws Error where RAINFALL has no such time or no time at all.
std::optional<GaugeReadings> shown_readings(Inputs& inputs, const StudyOptions& study,
                                            const RainfallOptions& rainfall,
                                            const std::string& time, Warnings& warnings);

}  // namespace thiessen::cli
