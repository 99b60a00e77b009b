#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/outputs.h"
#include "cli/commands/commands.h"
#include "cli/inputs/fitted_normals_of.h"
#include "cli/inputs/inputs.h"
#include "cli/options/blocks/common_options.h"
#include "cli/options/blocks/gap_options.h"
#include "cli/options/blocks/model_options.h"
#include "cli/options/blocks/output_options.h"
#include "cli/options/blocks/period_options.h"
#include "cli/options/blocks/rainfall_options.h"
#include "cli/options/blocks/study_options.h"
#include "cli/options/blocks/what_if_options.h"
#include "cli/outputs/model_files.h"
#include "cli/outputs/provenance_of.h"
#include "cli/terminal/progress.h"
#include "rainfall/influence/influence.h"
#include "rainfall/influence/step_blocks.h"
#include "rainfall/series/step_months.h"
#include "results/influence_file.h"
#include "results/weights_file.h"
#include "study/network_change.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t steps_in_a_block = 64;

class WeightsCommand : public Command {
 public:
  WeightsCommand() {
    study_.declare(options(), Need::required);
    rainfall_.declare_as_option(
        options(), "What if", "--influence",
        "what each gauge is worth by these readings (- reads standard input): CSV "
        "basin,station,weight,rms_change,mean_change, of a basin's rainfall without the gauge less "
        "that with it, both by the cells of the gauges that report, over all steps that have both, "
        "and with the normals of each step's month where months have their own; weight 0: it "
        "weighs only while others are silent");
    changes_.declare(options());
    range_.declare_range(options());
    range_.declare_stamp(options(),
                         "which month's normals count, and over which steps a total is spread "
                         "(--totals)");
    rainfall_.times_are_of(range_);
    gaps_.declare_cache(options());
    output_.declare(options(), Need::optional, "weights.csv",
                    "where the table goes, PG:... is a database; default standard output");
    output_.declare_table(options(), "weights");
    model_.declare(options());
    common_.declare(options());
  }

  const char* name() const override { return "weights"; }
  const char* description() const override {
    return "the weights table: each station's share of each basin";
  }
  const char* example() const override {
    return "samples/textbook/stations.csv samples/textbook/basin.csv --metric planar";
  }
  void check() const override {
    if (rainfall_.given()) {
      refuse_changes();
    } else {
      refuse_options_of_readings();
    }
    rainfall_.check_files();
    rainfall_.totals().check(rainfall_.given(), false);
    rainfall_.check_units();
    changes_.check();
    range_.check();
    study_.check();
    check_stamp();
    model_.check({.is_influence = rainfall_.given(),
                  .is_change = changes_.given(),
                  .is_database = output_.is_database()});
    if (study_.fits_normals() && !rainfall_.given()) {
      throw UsageError{"normals are fitted by elevation to RAINFALL, and there is none",
                       "--influence RAINFALL has some; run writes a weights.csv with factors, and "
                       "--normals and --normal-field take normals that are known"};
    }
    if (model_.model() && study_.has_normals()) {
      throw UsageError{model_.name() + " has no place for factors, and normals make them",
                       "--format csv has a column factor, and rain --format writes the basins' "
                       "rainfall with normals"};
    }
    output_.check();
  }

  void run(Warnings& warnings) override {
    const std::optional<StepTimes> times = range_.times();
    Outputs outputs(output_.rules(input_files()));
    std::optional<DatabaseTable> table;
    if (output_.is_database()) {
      table.emplace(output_.table());
    } else if (!model_.is_named()) {
      require_table_name(output_.output);
    }
    OutputFile& file = table ? table->rows() : outputs.add(output_.output);
    std::string unit;
    study_.opened = changes_.opened();
    Inputs inputs(study_, 0, rainfall_, common_.threads, warnings);
    fit_normals(inputs, study_, rainfall_, {.stamp = range_.stamp(), .threads = common_.threads},
                warnings);
    if (rainfall_.given()) {
      write_influence(file, inputs.weighing(), influence(inputs, times, unit, warnings));
    } else if (changes_.given()) {
      const NetworkChange change(inputs.whole(), changes_.closed(), inputs.study().filtered_ids,
                                 "--without");
      change.warn_of_shared_places(warnings);
      const auto before = inputs.weighing().weights_by_month(change.before(), threads());
      const auto after = inputs.weighing().weights_by_month(change.after(), threads());
      change.warn_of_no_effect(before.front(), after.front(), warnings);
      write_changed_weights(file, inputs.weighing(), before, after, inputs.area_unit());
    } else if (model_.model()) {
      write_model(file, inputs, warnings);
    } else {
      write_weights(file, inputs.weighing(),
                    inputs.weighing().weights_by_month(inputs.all_report(), threads()),
                    inputs.area_unit(), threads());
    }
    outputs.commit();
    if (!table) return;
    Provenance made_by = provenance_of(inputs, study_, nullptr, "");
    made_by.unit = unit;
    table->commit(sentence_of(made_by));
  }
  bool quiet() const override { return common_.quiet; }

 private:
  unsigned threads() const { return static_cast<unsigned>(common_.threads); }

  std::vector<std::string> input_files() const { return rainfall_.files_beside(study_.files()); }

  void refuse_changes() const {
    if (!changes_.given()) return;
    throw UsageError{"--influence looks at the network as it is, --with and --without change it",
                     "ask for one at a time"};
  }

  void check_stamp() const {
    if (range_.stamp_option() == nullptr || study_.has_normals() || rainfall_.totals().given())
      return;
    throw UsageError{
        "--stamp is about normals of months and totals beside RAINFALL, and there are none",
        "give --normals, --normal-field or --totals, or leave it out"};
  }

  void refuse_options_of_readings() const {
    const std::array<const OptionBlock*, 4> blocks{&rainfall_, &rainfall_.totals(), &range_,
                                                   &gaps_};
    for (const OptionBlock* block : blocks) {
      const Option* option = block->first_given();
      if (option == nullptr) continue;
      throw UsageError{option->name + " is about readings, and there is no --influence",
                       "give --influence RAINFALL, or leave it out"};
    }
  }

  void write_model(OutputFile& file, const Inputs& inputs, Warnings& warnings) const {
    const auto weights = inputs.weighing().weights(inputs.all_report(), threads());
    weights_format(*model_.model())
        ->write(file, {inputs.weighing(), weights, provenance_of(inputs, study_, nullptr, "")},
                warnings);
    warnings.add_notice({output_.output == "-" ? "" : output_.output, 0,
                         "these weights are those of all stations in every step; where some are "
                         "silent, rain gives their ground to others",
                         ""});
  }

  /// `unit` becomes that of the changes; empty where it is not known.
  std::vector<std::vector<GaugeInfluence>> influence(Inputs& inputs,
                                                     const std::optional<StepTimes>& times,
                                                     std::string& unit, Warnings& warnings) {
    const auto readings = inputs.open_readings(study_, rainfall_, warnings, times);
    unit = readings->unit();
    range_.settle_stamp(readings->stamp(), rainfall_.name());
    const Handovers handovers(inputs.weighing(), threads());
    Influence influence(handovers, gaps_.settings().remembered_bytes, threads());
    Progress progress("time step", common_.quiet,
                      [&](std::size_t done) { return readings->share_of(done); });
    for_each_block(*readings, steps_in_a_block, threads(), month_of(inputs),
                   [&](const StepBlock& block) {
                     influence.add(block.rows, block.months);
                     progress.advance(block.rows.size());
                   });
    return influence.result();
  }

  /// What tells the month of a step, where months have normals of their own; else empty.
  MonthOfTime month_of(const Inputs& inputs) const {
    const NormalField* const normals = inputs.weighing().normals();
    if (normals == nullptr || normals->months() == 1) return {};
    return [months = StepMonths(rainfall_.name(), range_.stamp())](const TimeStep& step) {
      return months.of(step.time, step.written, step.line);
    };
  }

  StudyOptions study_;
  RainfallOptions rainfall_;
  WhatIfOptions changes_;
  PeriodOptions range_;
  GapOptions gaps_;
  WeightsModelOptions model_;
  OutputOptions output_;
  CommonOptions common_;
};

}  // namespace

std::unique_ptr<Command> make_weights_command() {
  return std::make_unique<WeightsCommand>();
}

}  // namespace thiessen::cli
