#include "cli/inputs/gauges.h"

#include <algorithm>
#include <cmath>

#include "base/utf8.h"

namespace thiessen::cli {

std::optional<GaugeReadings> shown_readings(Inputs& inputs, const StudyOptions& study,
                                            const RainfallOptions& rainfall,
                                            const std::string& time, Warnings& warnings) {
  if (!rainfall.given()) return {};
  const auto readings = inputs.open_readings(study, rainfall, warnings);
  GaugeReadings shown = read_gauges(*readings, inputs.network(), time);
  if (rainfall.is_event() && time.empty()) shown.label = rainfall.event();
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

std::string unit_shown(const std::string& known, const std::string& said, bool is_said,
                       const std::string& file) {
  if (known.empty() || (is_said && known == said)) return said;
  if (!is_said) return known;
  throw Error({file, 0, "the readings are in " + known + ", and --units says " + quoted(said, 40),
               "--to-unit brings them to another unit; --units is for what has none"});
}

}  // namespace thiessen::cli
