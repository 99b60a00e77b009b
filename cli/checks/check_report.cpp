#include "cli/checks/check_report.h"

#include <utility>
#include <vector>

#include "base/number.h"
#include "cli/checks/plane_report.h"
#include "readings/units/rain_unit.h"

namespace thiessen::cli {
namespace {

std::string count(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string at_places(const Network& network) {
  return count(network.stations().size(), "station", "stations") + " at " +
         count(network.places().size(), "place", "places") + "\n";
}

/// The network that there would be if all stations of the file reported.
Network of_all_stations(const Inputs& inputs) {
  std::vector<Station> stations = inputs.network().stations();
  stations.insert(stations.end(), inputs.never_reporting().begin(), inputs.never_reporting().end());
  return {std::move(stations), inputs.study().metric};
}

std::string describe_intervals(const StepIntervals& intervals) {
  if (intervals.has_labels()) return "step: none, the times are labels\n";
  if (intervals.times() < 2) return "";
  const std::optional<StepLength> step = intervals.step();
  if (!step) return "step: irregular\n";
  std::string text = "step: " + text_of(*step);
  const auto lacking = intervals.lacking(*step);
  if (!lacking) return text + "; the times are in no order\n";
  if (lacking->steps == 0) return text + ", none lacks\n";
  text +=
      "; " + count(lacking->steps, "step lacks", "steps lack") + ", the first at " + lacking->first;
  if (lacking->steps > 1) text += ", the last at " + lacking->last;
  return text + "\n";
}

/// Rates are told, for their totals are not their sums.
std::string describe_unit(const std::string& name) {
  const std::optional<RainUnit> unit = rain_unit(name);
  if (!unit || !time_of_rate(*unit)) return "";
  return "unit: " + name + ", a rate: totals count each value times its step\n";
}

}  // namespace

std::string describe_study(const Inputs& inputs) {
  const StudyFiles& study = inputs.study();
  const Network& network = inputs.network();
  std::string text = "stations: " + at_places(of_all_stations(inputs));
  if (!inputs.never_reporting().empty()) text += "full network: " + at_places(network);
  const auto name = [](const std::optional<Crs>& crs) {
    return crs ? printable(crs->name()) : "unknown";
  };
  text += "CRS: stations " + name(study.stations_crs);
  if (inputs.has_basins()) text += ", basins " + name(study.basins_crs);
  text +=
      std::string("\nmetric: ") + (study.metric == Metric::geodesic ? "geodesic" : "planar") + "\n";
  return text + describe_plane(inputs);
}

std::string describe_weights(const WeightFindings& findings) {
  return "basins: " + count(findings.basins.size(), "basin", "basins") + ", " +
         std::to_string(findings.basins_without_gauge) +
         " without a gauge inside\ngauges that weigh in no basin: " +
         std::to_string(findings.idle_gauges) + "\n";
}

std::string describe_steps(const Inputs& inputs, const PassedSteps& passed) {
  const std::size_t never = inputs.never_reporting().size();
  const std::size_t missing = passed.missing + passed.steps * never;
  const double all = static_cast<double>(passed.steps) *
                     static_cast<double>(inputs.network().stations().size() + never);
  const std::string share =
      all > 0 ? fixed_text(100 * static_cast<double>(missing) / all, 1) : "0.0";
  return "readings: " + count(passed.steps, "time step", "time steps") + ", " + share +
         " % missing\n" + describe_unit(passed.unit) + describe_intervals(passed.intervals);
}

}  // namespace thiessen::cli
