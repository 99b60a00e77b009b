#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/outputs.h"
#include "cli/commands/commands.h"
#include "cli/inputs/fitted_normals_of.h"
#include "cli/inputs/gauges.h"
#include "cli/inputs/inputs.h"
#include "cli/inputs/summed_rates.h"
#include "cli/options/blocks/common_options.h"
#include "cli/options/blocks/gap_options.h"
#include "cli/options/blocks/isohyet_options.h"
#include "cli/options/blocks/output_options.h"
#include "cli/options/blocks/period_options.h"
#include "cli/options/blocks/rain_format_options.h"
#include "cli/options/blocks/rainfall_options.h"
#include "cli/options/blocks/study_options.h"
#include "cli/options/blocks/view_options.h"
#include "cli/options/study_file.h"
#include "cli/outputs/cell_features.h"
#include "cli/outputs/encoded_files.h"
#include "cli/outputs/held_rain.h"
#include "cli/outputs/picture_of.h"
#include "cli/outputs/provenance_of.h"
#include "cli/outputs/rain_table.h"
#include "cli/outputs/report_of.h"
#include "cli/outputs/study_package_of.h"
#include "cli/summary/summary.h"
#include "cli/terminal/line_width.h"
#include "cli/terminal/progress.h"
#include "files/geopackage_copy.h"
#include "gdal/output/image_file.h"
#include "rainfall/errors/mean_error.h"
#include "rainfall/methods/method_rainfall.h"
#include "rainfall/series/gauge_readings.h"
#include "rainfall/series/step_months.h"
#include "results/summary_file.h"
#include "results/weights_file.h"

namespace thiessen::cli {
namespace {

/// Whether calendar months have normals of their own.
bool tells_months(const Inputs& inputs) {
  const NormalField* const normals = inputs.weighing().normals();
  return normals != nullptr && normals->months() > 1;
}

/// What a run gathers while the steps pass.
class RunSeries {
 public:
  RunSeries(const Inputs& inputs, const ArealRainfall& rainfall, RainTable& table)
      : means(inputs.network()),
        summary(inputs, rainfall.full_weights()),
        report(inputs),
        rainfall_(rainfall),
        table_(table),
        error_(rainfall, inputs.weighing()) {
    table.tell(
        [&](const std::string& time, std::span<const double> values) { held.add(time, values); });
  }
  RunSeries(const RunSeries&) = delete;
  RunSeries& operator=(const RunSeries&) = delete;

  void add(const RainStep& step, const NormalMonth& month) {
    table_.add(step);
    means.add(step.readings);
    means.note(step.time, calendar_time(step.time, step.written));
    error_.add(step.readings, step.basins, month);
    summary.add(step, month);
    report.add(step);
  }
  void finish(unsigned threads) {
    if (rainfall_.leaves_silent_out()) summary.find_most_influential(rainfall_, threads);
    std::vector<double> errors = error_.result(threads);
    summary.set_errors_of_mean(std::move(errors), error_.shortfall());
  }

  HeldRain held;
  MeanReadings means;
  Summary summary;
  StudyReport report;

 private:
  const ArealRainfall& rainfall_;
  RainTable& table_;
  MeanError error_;
};

class RunCommand : public Command {
 public:
  RunCommand() {
    study_.declare(options(), Need::required);
    rainfall_.declare(options(), Need::required, study_.stations);
    gaps_.declare(options());
    format_.declare(options());
    periods_.declare(options());
    periods_.declare_depths(options());
    rainfall_.times_are_of(periods_);
    view_.declare_look(options());
    study_.declare_label(options());
    isohyets_.declare_study(options());
    study_.declare_attributes(options());
    output_.declare_folder(options(), "the folder; it is made if it is not there");
    common_.declare(options());
  }

  const char* name() const override { return "run"; }
  const char* description() const override {
    return "everything in one folder: cells.geojson, weights.csv, rain.csv, map.png, summary.csv, "
           "which is printed as a table, report.html, a page with all of it for a browser, "
           "study.gpkg for a GIS, and the study.toml that repeats it";
  }
  const char* example() const override {
    return "samples/colorado/stations.csv samples/colorado/counties.geojson "
           "samples/colorado/rainfall.csv --basin-id name -o results";
  }
  void check() const override {
    periods_.check(study_.has_normals() || rainfall_.totals().given());
    format_.check(periods_.totalling().has_value());
    if (output_.output == "-") throw UsageError{"run writes a folder, not standard output", ""};
    study_.check();
    rainfall_.check();
    view_.check(true, true);
  }

  void run(Warnings& warnings) override {
    const std::optional<StepTimes> times = periods_.times();
    check_picture_size(static_cast<int>(view_.size.width), static_cast<int>(view_.size.height));
    check_picture_memory(static_cast<int>(view_.size.width), static_cast<int>(view_.size.height),
                         PictureFormat::png);
    Outputs outputs(output_.rules(rainfall_.files_beside(study_.files())));
    Warnings of_study_file;  // which are none of the study's: the page of its repetition has none
    const Files files = open_files(outputs, of_study_file);
    const std::unique_ptr<GeoPackageCopy> older = older_layers(files.package.name());

    Inputs inputs(study_, 0, rainfall_, common_.threads, warnings);
    fit_normals(inputs, study_, rainfall_, {.stamp = periods_.stamp(), .threads = common_.threads},
                warnings);
    const auto readings = inputs.open_readings(study_, rainfall_, warnings, times);
    periods_.settle_stamp(readings->stamp(), rainfall_.name());
    view_.units =
        unit_shown(readings->unit(), view_.units, view_.are_units_given(), rainfall_.name());
    ArealRainfallSettings settings = gaps_.settings();
    settings.accounts = format_.format().rows_for_basins && !periods_.totalling();
    const ArealRainfall rainfall(inputs.weighing(), settings, threads());
    write_weights(files.weights, inputs.weighing(), weights_of(inputs, rainfall),
                  inputs.area_unit(), threads());
    const auto by_month = monthly(inputs, rainfall);

    std::optional<Totalling> totalling = periods_.totalling();
    if (totalling) settle_totals(*totalling, inputs, study_, rainfall_, view_.units, warnings);
    RainFormat format = format_.format();
    format.storms = periods_.are_storms();
    RainTable table(files.rain, inputs.basins(), format, totalling, rainfall_.name());
    RunSeries series(inputs, rainfall, table);
    series.summary.want_depths(periods_.depths(), rainfall_.name());
    {
      Progress progress("time step", common_.quiet,
                        [&](std::size_t done) { return readings->share_of(done); });
      const StepMonths months(rainfall_.name(), periods_.stamp());
      SeriesWork work{threads()};
      work.month_of = [&](const RainStep& step) {
        return months.of(step.time, step.written, step.line);
      };
      for_each_step(
          *readings, by_month ? static_cast<const StepRainfall&>(*by_month) : rainfall, work,
          [&](RainStep& step) { table.prepare(step); },
          [&](const RainStep& step) {
            series.add(step, by_month ? NormalMonth(work.month_of(step)) : NormalMonth());
            progress.advance();
          });
    }
    table.finish(warnings);
    series.summary.find_depths(view_.units);
    series.finish(threads());
    write_summary(files.summary, series.summary.basins(), inputs.area_unit());
    write_maps(files, inputs, rainfall, series, older ? older->bytes() : "", warnings);
    for (const Message& message : of_study_file.messages()) warnings.add(message);
    if (!common_.quiet) outputs.add("-").append(series.summary.text(view_.units, line_width()));
    outputs.commit();
  }
  bool quiet() const override { return common_.quiet; }

 private:
  struct Files {
    OutputFile& cells;
    OutputFile& weights;
    OutputFile& rain;
    OutputFile& map;
    OutputFile& summary;
    OutputFile& report;
    OutputFile& package;
  };

  unsigned threads() const { return static_cast<unsigned>(common_.threads); }

  /// The weights of all gauges, and where months have normals of their own those of each.
  std::vector<std::vector<BasinWeights>> weights_of(const Inputs& inputs,
                                                    const ArealRainfall& rainfall) const {
    if (tells_months(inputs))
      return inputs.weighing().weights_by_month(inputs.all_report(), threads());
    return {rainfall.full_weights()};
  }
  /// The rainfall of each calendar month, where months have normals of their own; else null.
  static std::unique_ptr<const MonthlyRainfall> monthly(const Inputs& inputs,
                                                        const ArealRainfall& rainfall) {
    if (!tells_months(inputs)) return nullptr;
    std::vector<std::unique_ptr<const StepRainfall>> months;
    for (std::size_t m = 0; m < inputs.weighing().normals()->months(); ++m)
      months.push_back(rainfall.of_month(m));
    return std::make_unique<const MonthlyRainfall>(std::move(months), rainfall.of_month({}));
  }

  Files open_files(Outputs& outputs, Warnings& warnings) const {
    outputs.make_folder(output_.output);
    const auto add = [&](const char* name) -> OutputFile& {
      return outputs.add(output_.output + name);
    };
    add("/study.toml").append(study_file_text(options(), name(), output_.output, warnings));
    return {add("/cells.geojson"), add("/weights.csv"), add("/rain.csv"),  add("/map.png"),
            add("/summary.csv"),   add("/report.html"), add("/study.gpkg")};
  }

  /// Writes what shows the gauges' means: cells, the picture, the page, and the study in one file.
  void write_maps(const Files& files, const Inputs& inputs, const ArealRainfall& rainfall,
                  RunSeries& series, const std::string& older_package, Warnings& warnings) const {
    GaugeReadings mean = series.means.of_all();
    tell_of_year(inputs, rainfall_, warnings);
    if (rainfall_.is_event()) mean.label = rainfall_.event();
    const auto cells = cells_of_network(inputs, threads());
    CellsOutput output = cells_output(inputs, cells, &mean, study_, view_.units);
    files.cells.append(cells_geojson(output, files.cells.name(), warnings));
    warn_of_new_names(output, files.cells.name(), warnings);
    warn_of_own_coordinates(inputs, files.cells.name(), warnings);
    const Picture picture = picture_of(inputs, cells, &mean, study_, view_);
    files.map.append(encode_picture(picture, PictureFormat::png, image_file, warnings));
    StudyPackage package = study_package_of(inputs, std::move(output),
                                            {.readings = &mean,
                                             .weights = &rainfall.full_weights(),
                                             .classes = classes_of(picture),
                                             .unit = view_.units,
                                             .interval = isohyets_.interval,
                                             .threads = threads()});
    package.layers.basins = series.summary.basins();
    package.layers.has_series = true;
    if (series.held.is_too_long()) {
      warnings.add_notice({files.package.name(), 0,
                           "it has no table of the rainfall, which is of more than a million "
                           "values; rain.csv has them",
                           ""});
    }
    package.layers.rain = series.held.take();
    files.package.append(
        study_package(std::move(package), files.package.name(), older_package, warnings));
    files.report.append(
        series.report.page({.picture = &picture,
                            .summary = &series.summary,
                            .weights = &rainfall.full_weights(),
                            .options = &options(),
                            .made_by = provenance_of(inputs, study_, &mean, view_.units),
                            .unit = view_.units,
                            .gaps = gaps_.settings().gaps,
                            .has_totals = periods_.totalling().has_value()},
                           warnings));
  }

  StudyOptions study_;
  RainfallOptions rainfall_;
  GapOptions gaps_;
  RainFormatOptions format_;
  PeriodOptions periods_;
  ViewOptions view_;
  IsohyetOptions isohyets_;
  OutputOptions output_;
  CommonOptions common_;
};

}  // namespace

std::unique_ptr<Command> make_run_command() {
  return std::make_unique<RunCommand>();
}

}  // namespace thiessen::cli
