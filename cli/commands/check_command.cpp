#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "base/iso_time.h"
#include "base/number.h"
#include "base/outputs.h"
#include "cli/commands/commands.h"
#include "cli/inputs/inputs.h"
#include "cli/options/common_options.h"
#include "cli/options/output_options.h"
#include "cli/options/rainfall_options.h"
#include "cli/options/study_options.h"
#include "cli/options/usage_error.h"
#include "cli/outputs/check_report.h"
#include "cli/outputs/distances_report.h"
#include "cli/outputs/findings_report.h"
#include "rainfall/series/step_intervals.h"
#include "study/weight_findings.h"

namespace thiessen::cli {
namespace {

class CheckCommand : public Command {
 public:
  CheckCommand() {
    study_.declare(options(), Need::optional);
    rainfall_.declare(options(), Need::optional, study_.stations);
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
    check_output();
  }

  void run(Warnings& warnings) override {
    Outputs outputs(output_.rules(rainfall_.files_beside(study_.files())));
    if (is_output_wanted()) {
      require_table_name(output_.output);
      findings_ = &outputs.add(output_.output);
    }
    Inputs inputs(study_, 10, rainfall_, common_.threads, warnings);
    std::string report = describe_study(inputs) + odd_gauges_text(inputs);
    if (inputs.has_basins()) report += describe_basins(inputs, warnings);
    if (rainfall_.given()) report += describe_readings(inputs, warnings);
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

  std::string describe_readings(Inputs& inputs, Warnings& warnings) const {
    const auto readings = inputs.open_readings(study_, rainfall_, warnings);
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
      for (const double reading : step.readings) missing += std::isnan(reading) ? 1u : 0u;
      if (findings) findings->see(step);
    }
    return describe_steps(inputs, {steps, missing, intervals, readings->unit()}) +
           (findings ? findings->text() : "");
  }

  StudyOptions study_;
  RainfallOptions rainfall_;
  OutputOptions output_;
  CommonOptions common_;
  OutputFile* findings_ = nullptr;  ///< where all findings go; null where they are not wanted
};

}  // namespace

std::unique_ptr<Command> make_check_command() {
  return std::make_unique<CheckCommand>();
}

}  // namespace thiessen::cli
