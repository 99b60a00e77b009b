#include "cli/inputs/gauges.h"

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
  return shown;
}

}  // namespace thiessen::cli
