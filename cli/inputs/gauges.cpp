#include "cli/inputs/gauges.h"

#include <algorithm>
#include <cmath>

namespace thiessen::cli {

std::optional<GaugeReadings> shown_readings(Inputs& inputs, const StudyOptions& study,
                                            const RainfallOptions& rainfall,
                                            const std::string& time, Warnings& warnings) {
  if (!rainfall.given()) return {};
  const auto readings = inputs.open_readings(study, rainfall, warnings);
  GaugeReadings shown = read_gauges(*readings, inputs.network(), time);
  if (shown.readings.empty()) {
    throw Error({rainfall.name(), 0, "there is no time step '" + time + "'",
                 "a time is written just as in the file"});
  }
  const bool silent = std::all_of(shown.readings.begin(), shown.readings.end(),
                                  [](double reading) { return std::isnan(reading); });
  if (silent && !time.empty())
    warnings.add({rainfall.name(), 0, "no gauge reports in the time step '" + time + "'", ""});
  return shown;
}

}  // namespace thiessen::cli
