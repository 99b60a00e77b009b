#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/destination.h"
#include "base/interrupt.h"
#include "base/outputs.h"
#include "cli/commands/commands.h"
#include "cli/inputs/fitted_normals_of.h"
#include "cli/inputs/gauges.h"
#include "cli/inputs/inputs.h"
#include "cli/inputs/summed_rates.h"
#include "cli/options/blocks/common_options.h"
#include "cli/options/blocks/gap_options.h"
#include "cli/options/blocks/method_options.h"
#include "cli/options/blocks/model_options.h"
#include "cli/options/blocks/output_options.h"
#include "cli/options/blocks/period_options.h"
#include "cli/options/blocks/rain_format_options.h"
#include "cli/options/blocks/rainfall_options.h"
#include "cli/options/blocks/study_options.h"
#include "cli/options/option_values.h"
#include "cli/outputs/grown_table.h"
#include "cli/outputs/model_files.h"
#include "cli/outputs/model_table.h"
#include "cli/outputs/provenance_of.h"
#include "cli/outputs/rain_table.h"
#include "cli/terminal/messages.h"
#include "cli/terminal/progress.h"
#include "files/basin_centroids.h"
#include "files/rainfall/rainfall_file.h"
#include "rainfall/errors/error_correlation.h"
#include "rainfall/errors/errors_of_series.h"
#include "rainfall/series/gauge_patterns.h"
#include "rainfall/series/step_months.h"
#include "results/weights_log.h"

namespace thiessen::cli {
namespace {

/// Where the series and its account go: one of the four, and the account where it is wanted.
struct Destination {
  explicit Destination(const OutputRules& rules) : outputs(rules) {}

  Outputs outputs;
  std::optional<DatabaseTable> table;
  std::optional<GrownTable> grown;
  std::optional<ModelFiles> model;
  OutputFile* file = nullptr;
  OutputFile* log = nullptr;
};

/// The account of weights, a block for each set of reporting gauges, where there is a file for it.
class WeightsAccount {
 public:
  WeightsAccount(OutputFile* file, const Weighing& weighing) {
    if (file != nullptr) log_.emplace(*file, weighing);
  }

  /// The number of a step's set of gauges, whose weights are written where it is new.
  std::size_t pattern_of(const RainStep& step, const StepRainfall& rainfall,
                         const SeriesWork& work) {
    if (!log_) return 0;
    const std::size_t month = rainfall.tells_months() ? work.month_of(step) + 1 : 0;
    const GaugePatterns::Pattern pattern = patterns_.of(step.readings, month);
    if (pattern.is_fresh) {
      log_->add(pattern.number, step.time,
                rainfall_at(rainfall, step, work).weights_at(step.readings));
    }
    return pattern.number;
  }

 private:
  std::optional<WeightsLog> log_;
  GaugePatterns patterns_;
};

class RainCommand : public Command {
 public:
  RainCommand() {
    study_.declare(options(), Need::required);
    rainfall_.declare(options(), Need::required, study_.stations);
    method_.declare(options());
    gaps_.declare(options());
    declare_errors();
    format_.declare(options());
    model_.declare(options());
    periods_.declare(options());
    rainfall_.times_are_of(periods_);
    output_.declare(options(), Need::optional, "rain.csv",
                    "where the series goes, PG:... is a database (as --long); default standard "
                    "output");
    output_.declare_append(options());
    output_.declare_table(options(), "rain");
    declare_account();
    common_.declare(options());
  }

  const char* name() const override { return "rain"; }
  const char* description() const override { return "areal rainfall, one row a time step"; }
  const char* example() const override {
    return "samples/textbook/stations.csv samples/textbook/basin.csv "
           "samples/textbook/rainfall.csv --metric planar";
  }
  void check() const override {
    periods_.check(model_.model().has_value() || study_.has_normals() ||
                   rainfall_.totals().given());
    model_.check(options(), output_.output, method_.methods().size());
    if (model_.model() && periods_.are_storms()) {
      throw UsageError{"--every storm has periods of any length, and --format " + model_.name() +
                           " wants steps of one",
                       "--format csv has when each begins, and with --long its last wet step"};
    }
    format_.check(periods_.totalling().has_value());
    method_.check();
    if ((method_.methods().size() > 1 || method_.has_isohyets()) && !weights_log_.empty()) {
      throw UsageError{
          method_.has_isohyets()
              ? "--weights-log is of methods that weigh gauges, and isohyets do not"
              : "--weights-log is the account of one method, and --method says several",
          "give one of thiessen, arithmetic, idw and natural"};
    }
    method_.check(gaps_);
    check_errors_can_be_had();
    check_append();
    study_.check();
    rainfall_.check();
  }

  const char* when_interrupted() const override {
    return may_pass_on() ? "interrupted; what was written before stays"
                         : "interrupted; nothing was written";
  }

  void run(Warnings& warnings) override {
    const std::optional<StepTimes> times = periods_.times();
    require_what_is_asked_for();
    const bool is_fed = may_pass_on();
    if (is_fed) want_feed();
    const OutputRules rules = output_.rules(rainfall_.files_beside(study_.files()));
    Destination to(rules);
    open(to, rules, is_fed);
    Inputs inputs(study_, 0, rainfall_, common_.threads, warnings);
    fit_normals(inputs, study_, rainfall_, {.stamp = periods_.stamp(), .threads = common_.threads},
                warnings);
    RainFormat format = table_format();
    std::shared_ptr<const ErrorCorrelation> in_time;
    const auto rainfall = step_rainfall(inputs, format, in_time, warnings);
    const auto readings = inputs.open_readings(study_, rainfall_, warnings, times);
    periods_.settle_stamp(readings->stamp(), rainfall_.name());
    std::optional<Totalling> totalling = totals(is_fed);
    if (totalling) settle_totals(*totalling, inputs, study_, rainfall_, readings->unit(), warnings);
    if (totalling) totalling->errors = in_time;
    auto& grown = to.grown;
    if (grown) to.file = &grown->begin(inputs.basins(), format, totalling.has_value(), warnings);
    if (grown && rainfall_.is_cumulative()) grown->growth()->is_of_counters();
    const std::string unit = unit_named(readings->unit(), totalling);
    const auto series =
        to.model ? model_table(*to.model, inputs, unit, totalling)
                 : std::make_unique<RainTable>(*to.file, inputs.basins(), format, totalling,
                                               rainfall_.name(), grown ? grown->growth() : nullptr);
    WeightsAccount account(to.log, inputs.weighing());
    Progress progress("time step", common_.quiet,
                      [&](std::size_t done) { return readings->share_of(done); });
    SeriesWork work{threads()};
    if (is_fed && grown) work.when_handed_on = [&] { pass_on(*grown, warnings); };
    if (is_fed && !grown) work.when_handed_on = [&] { pass_on(*to.file, warnings); };
    const StepMonths months(rainfall_.name(), periods_.stamp());
    work.month_of = [&](const RainStep& step) {
      return months.of(step.time, step.written, step.line);
    };
    for_each_step(
        *readings, *rainfall, work, [&](RainStep& step) { series->prepare(step); },
        [&](const RainStep& step) {
          series->add(step, account.pattern_of(step, *rainfall, work));
          progress.advance();
        });
    series->finish(warnings);
    if (grown) grown->finish(warnings);
    to.outputs.commit();
    if (to.table) to.table->commit(sentence_of(made_by(inputs, unit)));
  }
  bool quiet() const override { return common_.quiet; }

 private:
  void open(Destination& to, const OutputRules& rules, bool is_fed) const {
    if (is_fed) to.outputs.pass_on_at_once();
    if (model_.model()) {
      to.model.emplace(*model_.model(), output_.output, to.outputs, rules);
    } else if (output_.is_database()) {
      to.file = &to.table.emplace(output_.table()).rows();
    } else if (output_.appends()) {
      to.grown.emplace(output_.output, rules, is_fed);
    } else {
      to.file = &to.outputs.add(output_.output);
    }
    if (!weights_log_.empty()) to.log = &to.outputs.add(weights_log_);
  }

  void require_what_is_asked_for() const {
    if (errors_) require_two_readings();
    if (!output_.is_database() && !model_.is_named()) require_table_name(output_.output);
    require_table_name(weights_log_);
  }

  void want_feed() {
    rainfall_.want_steps_as_they_come();
    if (output_.appends()) rainfall_.want_steps_once();
  }

  void declare_errors() {
    options().group("Method").add(
        "--error", flag(errors_),
        "the standard error of each value, in columns BASIN_se after all others, or with "
        "--long in a column se: 1.96 of them to each side are a 95 % bar (widened where "
        "few gauges report) for the true mean of a field alike everywhere, or with normals of "
        "one that they lift; without them bars are too narrow in mountains, and README has "
        "what was measured. With --every of each total, by how the differences of near gauges "
        "go on from step to step. Of any method that weighs gauges. RAINFALL is read twice, all of "
        "it; empty where fewer than five gauges report or all that do read the same; 10 steps "
        "are needed");
  }

  void declare_account() {
    OptionValue value = text(weights_log_, "FILE");
    value.completion = Completion::file;
    options().group("Output").add(
        "--weights-log", std::move(value),
        "the account: CSV pattern,first_time,basin,station,weight (with normals and factor), a "
        "block for each set of reporting gauges (and month, where months have normals); --long, "
        "without --every, then has a column pattern");
  }

  void check_append() const {
    output_.check();
    if (!output_.appends() || weights_log_.empty()) return;
    throw UsageError{"--weights-log is the account of a whole series, and --append adds to one",
                     "leave one of them out"};
  }

  void check_errors_can_be_had() const {
    if (!errors_) return;
    method_.check_errors();
    if (rainfall_.is_standard_input()) {
      throw UsageError{"--error reads RAINFALL twice, and standard input can be read once",
                       "give a file"};
    }
  }

  unsigned threads() const { return static_cast<unsigned>(common_.threads); }

  RainFormat table_format() const {
    RainFormat format = format_.format();
    // A column a basin would be a table of other columns with each study.
    format.rows_for_basins = format.rows_for_basins || output_.is_database();
    format.patterns = !weights_log_.empty();
    format.errors = errors_;
    format.methods = names_of_methods(method_.methods());
    format.storms = periods_.are_storms();
    return format;
  }

  /// The unit that the values are said to be in, where something says it.
  std::string unit_named(const std::string& of_readings,
                         const std::optional<Totalling>& totalling) const {
    return unit_shown(unit_of_values(of_readings, totalling), model_.units,
                      model_.are_units_given(), rainfall_.name());
  }

  /// What is said of how the series is made.
  Provenance made_by(const Inputs& inputs, const std::string& unit) const {
    Provenance made_by = provenance_of(inputs, study_, nullptr, "");
    made_by.method.clear();
    for (const RainMethod method : method_.methods())
      made_by.method += (made_by.method.empty() ? "" : ",") + std::string(name_of(method));
    made_by.unit = unit;
    return made_by;
  }

  /// The series as a model reads it.
  std::unique_ptr<RainOutput> model_table(ModelFiles& files, const Inputs& inputs,
                                          const std::string& unit,
                                          const std::optional<Totalling>& totalling) const {
    ModelSubject subject;
    for (const Basin& basin : inputs.basins()) subject.basins.push_back(basin.id);
    subject.centroids = centroids_on_earth(inputs.study()).value_or(std::vector<Point>());
    subject.made_by = made_by(inputs, unit);
    subject.unit = subject.made_by.unit;
    subject.decimals = format_.format().decimals;
    subject.stamp = totalling ? Stamp::begin : periods_.stamp();  // periods are dated by that
    if (totalling) {
      subject.step = length_of(totalling->every);
      subject.day_start = totalling->every.day_start;
    }
    subject.rainfall = rainfall_.name();
    subject.output = output_.output == "-" ? "" : output_.output;
    return std::make_unique<ModelTable>(files.series(inputs, std::move(subject), errors_),
                                        model_.name(), totalling, rainfall_.name());
  }

  std::optional<Totalling> totals(bool is_fed) const {
    std::optional<Totalling> totalling = periods_.totalling();
    if (!totalling) return totalling;
    totalling->as_they_end = is_fed;
    totalling->whole_alone = output_.appends();
    return totalling;
  }

  /// What computes each step, and how the errors of steps go together where totals want them.
  std::unique_ptr<const StepRainfall> step_rainfall(
      Inputs& inputs, const RainFormat& format, std::shared_ptr<const ErrorCorrelation>& in_time,
      Warnings& warnings) {
    ArealRainfallSettings settings = gaps_.settings();
    settings.accounts = format.rows_for_basins && !periods_.totalling();
    std::optional<ErrorsOfSeries> errors;
    std::string shortfall;
    AroundRainfall around;
    if (errors_) {
      const auto of = periods_.totalling() ? ErrorsOfSeries::Of::totals : ErrorsOfSeries::Of::steps;
      read_for_errors(inputs, errors.emplace(inputs.weighing(), of));
      in_time = errors->correlation();
      around = [&](std::unique_ptr<const WeighedRainfall> values, const NormalMonth& month) {
        auto error = errors->of(std::move(values), month, threads());
        shortfall = error->shortfall();
        return error;
      };
    }
    auto rainfall = rainfall_by(method_.methods(), inputs.weighing(), method_.points(), settings,
                                threads(), warnings, around);
    if (!shortfall.empty()) {
      warnings.add({rainfall_.name(), 0, "no standard errors: " + shortfall, ""});
    } else if (in_time && inputs.weighing().normals() == nullptr) {
      warn_of_lasting_errors(*in_time, rainfall_.name(), warnings);
    }
    return rainfall;
  }

  /// Whether rows are handed over as they are computed, for RAINFALL is a pipe and they go where
  /// somebody sees them.
  bool may_pass_on() const {
    return rainfall_.is_fed() && !model_.model() &&
           (output_.appends() || goes_to_stream(output_.output));
  }

  /// Tells what is odd about a series so far, which may have no end.
  void tell(Warnings& warnings) const {
    if (!common_.quiet) print(warnings);
  }

  /// Hands over what is known so far. Throws ReaderGone where nobody wants to know.
  void pass_on(OutputFile& file, Warnings& warnings) const {
    tell(warnings);
    file.flush();
    if (file.is_reader_gone()) throw ReaderGone(Error(Message{file.name(), 0, "nobody reads", ""}));
  }

  void pass_on(GrownTable& table, Warnings& warnings) const {
    table.pass_on(warnings);
    tell(warnings);
  }

  /// Refuses a pipe, as it can be read only once.
  void require_two_readings() const {
    if (can_be_read_again(rainfall_.request({}))) return;
    throw UsageError{
        "--error reads RAINFALL twice, and " + printable(rainfall_.name()) + " is not a file", ""};
  }

  /// Reads RAINFALL for its variogram. Its warnings are dropped here, as they are given when it is
  /// read again.
  void read_for_errors(Inputs& inputs, ErrorsOfSeries& errors) {
    Warnings told_later;
    const auto readings = inputs.open_readings(study_, rainfall_, told_later, std::nullopt);
    periods_.settle_stamp(readings->stamp(), rainfall_.name());
    const StepMonths months(rainfall_.name(), periods_.stamp());
    const NormalField* const normals = inputs.weighing().normals();
    const bool tells_months = normals != nullptr && normals->months() > 1;
    Progress progress("time step", common_.quiet,
                      [&](std::size_t done) { return readings->share_of(done); });
    for (TimeStep step; readings->next(step); progress.advance()) {
      throw_if_interrupted();
      NormalMonth month;
      if (tells_months) month = months.of(step.time, step.written, step.line);
      errors.add(step.readings, month);
    }
  }

  StudyOptions study_;
  RainfallOptions rainfall_;
  MethodOptions method_;
  GapOptions gaps_;
  RainFormatOptions format_;
  RainModelOptions model_;
  PeriodOptions periods_;
  OutputOptions output_;
  std::string weights_log_;
  bool errors_ = false;
  CommonOptions common_;
};

}  // namespace

std::unique_ptr<Command> make_rain_command() {
  return std::make_unique<RainCommand>();
}

}  // namespace thiessen::cli
