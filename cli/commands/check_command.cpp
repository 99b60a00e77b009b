#include <cmath>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"
#include "cli/commands/commands.h"
#include "cli/inputs/inputs.h"
#include "cli/options/common_options.h"
#include "cli/options/rainfall_options.h"
#include "cli/options/study_options.h"
#include "cli/outputs/distances_report.h"
#include "cli/outputs/plane_report.h"
#include "rainfall/series/step_intervals.h"
#include "readings/rain_unit.h"
#include "study/weight_findings.h"

namespace thiessen::cli {
namespace {

class CheckCommand : public Command {
 public:
  CheckCommand() {
    study_.declare(options(), Need::optional);
    rainfall_.declare(options(), Need::optional, study_.stations);
    common_.declare(options());
  }

  const char* name() const override { return "check"; }
  const char* description() const override {
    return "says what is wrong or odd in the inputs; exit status 1 where a run would fail";
  }
  const char* example() const override {
    return "samples/colorado/stations.csv samples/colorado/counties.geojson "
           "samples/colorado/rainfall.csv";
  }
  void check() const override {
    study_.check();
    rainfall_.check();
  }

  void run(Warnings& warnings) override {
    Inputs inputs(study_, 10, rainfall_, common_.threads, warnings);
    std::string report = describe(inputs) + odd_gauges_text(inputs);
    if (inputs.has_basins()) report += describe_basins(inputs, warnings);
    if (rainfall_.given()) report += describe_readings(inputs, warnings);
    if (inputs.has_basins()) report += nearest_gauges_table(inputs);
    OutputFile out = standard_output();
    out.append(report);
    out.finish();
  }
  bool quiet() const override { return common_.quiet; }

 private:
  static std::string count(std::size_t n, const std::string& one, const std::string& many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
  }

  static std::string at_places(const Network& network) {
    return count(network.stations().size(), "station", "stations") + " at " +
           count(network.places().size(), "place", "places") + "\n";
  }

  /// The network that there would be if all stations of the file reported.
  static Network of_all_stations(const Inputs& inputs) {
    std::vector<Station> stations = inputs.network().stations();
    stations.insert(stations.end(), inputs.never_reporting().begin(),
                    inputs.never_reporting().end());
    return {std::move(stations), inputs.study().metric};
  }

  static std::string describe(const Inputs& inputs) {
    const StudyFiles& study = inputs.study();
    const Network& network = inputs.network();
    std::string text = "stations: " + at_places(of_all_stations(inputs));
    if (!inputs.never_reporting().empty()) text += "full network: " + at_places(network);
    const auto name = [](const std::optional<Crs>& crs) {
      return crs ? printable(crs->name()) : "unknown";
    };
    text += "CRS: stations " + name(study.stations_crs);
    if (inputs.has_basins()) text += ", basins " + name(study.basins_crs);
    text += std::string("\nmetric: ") + (study.metric == Metric::geodesic ? "geodesic" : "planar") +
            "\n";
    return text + describe_plane(inputs);
  }

  std::string describe_basins(const Inputs& inputs, Warnings& warnings) const {
    const auto weights =
        inputs.weighing().weights(inputs.all_report(), static_cast<unsigned>(common_.threads));
    const WeightFindings findings = findings_of(inputs.whole(), weights);
    for (std::size_t b = 0; b < weights.size(); ++b) {
      if (findings.basins[b].adds_up()) continue;
      warnings.add({study_.basins, 0,
                    "the weights of basin '" + inputs.basins()[b].id + "' add up to " +
                        shortest_text(findings.basins[b].sum) +
                        ", not to 1: a fault of the program itself",
                    "please report it with the input"});
    }
    return "basins: " + count(weights.size(), "basin", "basins") + ", " +
           std::to_string(findings.basins_without_gauge) +
           " without a gauge inside\ngauges that weigh in no basin: " +
           std::to_string(findings.idle_gauges) + "\n";
  }

  std::string describe_readings(Inputs& inputs, Warnings& warnings) const {
    const auto readings = inputs.open_readings(study_, rainfall_, warnings);
    std::size_t steps = 0;
    std::size_t missing = 0;
    StepIntervals intervals;
    TimeStep step;
    while (readings->next(step)) {
      throw_if_interrupted();
      ++steps;
      intervals.note(calendar_time(step.time, step.written));
      for (const double reading : step.readings) missing += std::isnan(reading) ? 1u : 0u;
    }
    missing += steps * inputs.never_reporting().size();
    const double all =
        static_cast<double>(steps) *
        static_cast<double>(inputs.network().stations().size() + inputs.never_reporting().size());
    const std::string share =
        all > 0 ? fixed_text(100 * static_cast<double>(missing) / all, 1) : "0.0";
    return "readings: " + count(steps, "time step", "time steps") + ", " + share + " % missing\n" +
           describe_unit(readings->unit()) + describe_steps(intervals);
  }

  /// Rates are told, for their totals are not their sums.
  static std::string describe_unit(const std::string& name) {
    const std::optional<RainUnit> unit = rain_unit(name);
    if (!unit || !time_of_rate(*unit)) return "";
    return "unit: " + name + ", a rate: totals count each value times its step\n";
  }

  static std::string describe_steps(const StepIntervals& intervals) {
    if (intervals.has_labels()) return "step: none, the times are labels\n";
    if (intervals.times() < 2) return "";
    const std::optional<StepLength> step = intervals.step();
    if (!step) return "step: irregular\n";
    std::string text = "step: " + text_of(*step);
    const auto lacking = intervals.lacking(*step);
    if (!lacking) return text + "; the times are in no order\n";
    if (lacking->steps == 0) return text + ", none lacks\n";
    text += "; " + count(lacking->steps, "step lacks", "steps lack") + ", the first at " +
            lacking->first;
    if (lacking->steps > 1) text += ", the last at " + lacking->last;
    return text + "\n";
  }

  StudyOptions study_;
  RainfallOptions rainfall_;
  CommonOptions common_;
};

}  // namespace

std::unique_ptr<Command> make_check_command() {
  return std::make_unique<CheckCommand>();
}

}  // namespace thiessen::cli
