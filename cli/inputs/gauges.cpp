#include "cli/inputs/gauges.h"

#include <algorithm>
#include <cmath>

#include "base/utf8.h"

namespace thiessen::cli {
namespace {

bool all_silent(const GaugeReadings& shown) {
  return std::all_of(shown.readings.begin(), shown.readings.end(),
                     [](double reading) { return std::isnan(reading); });
}

}  // namespace

std::optional<GaugeReadings> shown_readings(Inputs& inputs, const StudyOptions& study,
                                            const RainfallOptions& rainfall,
                                            const std::string& time, Warnings& warnings) {
  if (!rainfall.given()) return {};
  if (!time.empty()) return shown_steps(inputs, study, rainfall, {&time, 1}, warnings).front();
  tell_of_year(inputs, rainfall, warnings);
  GaugeReadings shown =
      read_gauges(*inputs.open_readings(study, rainfall, warnings), inputs.network(), "");
  if (rainfall.is_event()) shown.label = rainfall.event();
  return shown;
}

void tell_of_year(const Inputs& inputs, const RainfallOptions& rainfall, Warnings& warnings) {
  const NormalField* const normals = inputs.weighing().normals();
  if (normals == nullptr || normals->months() == 1) return;
  warnings.add_notice(
      {rainfall.name(), 0,
       "means over its steps are shown by normals of the year, which are the means of "
       "those of the months",
       ""});
}

std::vector<GaugeReadings> shown_steps(Inputs& inputs, const StudyOptions& study,
                                       const RainfallOptions& rainfall,
                                       std::span<const std::string> times, Warnings& warnings) {
  std::vector<GaugeReadings> steps =
      shown_steps(*inputs.open_readings(study, rainfall, warnings), inputs.network(),
                  rainfall.name(), times, warnings);
  require_months(inputs, rainfall.name(), steps);
  return steps;
}

void require_months(const Inputs& inputs, const std::string& rainfall,
                    std::span<const GaugeReadings> steps) {
  const NormalField* const normals = inputs.weighing().normals();
  for (const GaugeReadings& shown : steps) {
    if (normals == nullptr || normals->months() == 1 || shown.month) continue;
    throw Error({rainfall, 0,
                 "time " + quoted(shown.label, 80) +
                     " tells no calendar month, and normals are of calendar months",
                 "give normals of the year"});
  }
}

std::vector<GaugeReadings> shown_steps(Readings& readings, const Network& network,
                                       const std::string& name, std::span<const std::string> times,
                                       Warnings& warnings) {
  std::vector<GaugeReadings> steps = read_steps(readings, network, times);
  Complaints lacking;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!steps[i].readings.empty()) continue;
    lacking.add({name, 0, "there is no time step '" + times[i] + "'",
                 "a time is written just as in the file"});
  }
  lacking.throw_if_any();
  for (const GaugeReadings& shown : steps) {
    if (!all_silent(shown)) continue;
    warnings.add({name, 0, "no gauge reports in the time step '" + shown.label + "'", ""});
  }
  return steps;
}

std::string unit_shown(const std::string& known, const std::string& said, bool is_said,
                       const std::string& file) {
  if (known.empty() || (is_said && known == said)) return said;
  if (!is_said) return known;
  throw Error({file, 0, "the readings are in " + known + ", and --units says " + quoted(said, 40),
               "--to-unit brings them to another unit; --units is for what has none"});
}

}  // namespace thiessen::cli
