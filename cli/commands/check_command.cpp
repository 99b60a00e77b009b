#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "base/iso_time.h"
#include "base/number.h"
#include "base/outputs.h"
#include "cli/checks/check_report.h"
#include "cli/checks/distances_report.h"
#include "cli/checks/findings_report.h"
#include "cli/checks/methods_report.h"
#include "cli/commands/commands.h"
#include "cli/inputs/fitted_normals_of.h"
#include "cli/inputs/inputs.h"
#include "cli/options/blocks/common_options.h"
#include "cli/options/blocks/output_options.h"
#include "cli/options/blocks/rainfall_options.h"
#include "cli/options/blocks/study_options.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"
#include "rainfall/series/step_intervals.h"
#include "study/weight_findings.h"

namespace thiessen::cli {
namespace {

class CheckCommand : public Command {
 public:
  CheckCommand() {
    study_.declare(options(), Need::optional);
    rainfall_.declare(options(), Need::optional, study_.stations);
    rainfall_.declare_stamp(options());
    options().group("Method").add(
        "--methods", flag(methods_),
        "leave each gauge out of each step of RAINFALL, and say how far off thiessen, arithmetic, "
        "idw, natural and linear are that tell it by the others, with normals and without, at the "
        "steps and at sums of a year, by the gauges' elevations (field elev, elevation, z, alt or "
        "altitude), and which is best here");
    output_.declare(options(), Need::optional, "findings.csv",
                    "where all readings go that cannot be true beside those of the gauges next to "
                    "them, as CSV station,time,finding,value,expected; the time is empty where "
                    "the whole gauge is meant; --exclude takes the file");
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
    if (methods_ && !rainfall_.given())
      throw UsageError{"--methods leaves gauges out of RAINFALL, and there is none",
                       "give RAINFALL, or leave --methods out"};
    check_output();
  }

  void run(Warnings& warnings) override {
    study_.attributes = methods_;  // among them elevations
    Outputs outputs(output_.rules(rainfall_.files_beside(study_.files())));
    if (is_output_wanted()) {
      require_table_name(output_.output);
      findings_ = &outputs.add(output_.output);
    }
    Inputs inputs(study_, 10, rainfall_, common_.threads, warnings);
    const std::vector<double> elevations =
        fit_normals(inputs, study_, rainfall_,
                    {.stamp = rainfall_.stamp(), .threads = common_.threads}, warnings);
    std::string report = describe_study(inputs) + odd_gauges_text(inputs);
    if (inputs.has_basins()) report += describe_basins(inputs, warnings);
    if (rainfall_.given()) report += describe_readings(inputs, elevations, warnings);
    if (inputs.has_basins()) report += nearest_gauges_table(inputs);
    outputs.commit();
    OutputFile out = standard_output();
    out.append(report);
    out.finish();
  }
  bool quiet() const override { return common_.quiet; }

 private:
  bool is_output_wanted() const { return output_.is_given(); }

  void check_output() const {
    if (!is_output_wanted()) return;
    if (rainfall_.files().empty()) {
      throw UsageError{"--output is of findings in readings, and there is no RAINFALL",
                       "give RAINFALL, or leave it out"};
    }
    output_.check();
    if (output_.output != "-") return;
    throw UsageError{"the report goes to the standard output, and so would --output -",
                     "-o FILE names a file"};
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
    return describe_weights(findings);
  }

  std::string describe_readings(Inputs& inputs, const std::vector<double>& elevations,
                                Warnings& warnings) const {
    const auto readings = inputs.open_readings(study_, rainfall_, warnings);
    std::optional<MethodsReport> methods;
    if (methods_) {
      methods.emplace(inputs,
                      elevations.empty() ? elevations_in_attributes(inputs.study()) : elevations,
                      rainfall_.name(), readings->stamp().value_or(rainfall_.stamp()));
    }
    std::size_t steps = 0;
    std::size_t missing = 0;
    StepIntervals intervals;
    std::optional<FindingsReport> findings;
    if (!rainfall_.is_event())
      findings.emplace(inputs, readings->unit(), common_.threads, findings_);
    TimeStep step;
    while (readings->next(step)) {
      throw_if_interrupted();
      ++steps;
      intervals.note(calendar_time(step.time, step.written));
      if (methods) methods->add(step);
      for (const double reading : step.readings) missing += std::isnan(reading) ? 1u : 0u;
      if (findings) findings->see(step);
    }
    std::string text = describe_steps(inputs, {steps, missing, intervals, readings->unit()}) +
                       (findings ? findings->text() : "");
    if (!methods) return text;
    return text + methods->text(readings->unit(), static_cast<unsigned>(common_.threads));
  }

  StudyOptions study_;
  RainfallOptions rainfall_;
  OutputOptions output_;
  CommonOptions common_;
  bool methods_ = false;
  OutputFile* findings_ = nullptr;  ///< where all findings go; null where they are not wanted
};

}  // namespace

std::unique_ptr<Command> make_check_command() {
  return std::make_unique<CheckCommand>();
}

}  // namespace thiessen::cli
