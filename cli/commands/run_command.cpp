#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/outputs.h"
#include "cli/commands/commands.h"
#include "cli/inputs/gauges.h"
#include "cli/inputs/inputs.h"
#include "cli/inputs/summed_rates.h"
#include "cli/options/common_options.h"
#include "cli/options/gap_options.h"
#include "cli/options/isohyet_options.h"
#include "cli/options/output_options.h"
#include "cli/options/period_options.h"
#include "cli/options/rain_format_options.h"
#include "cli/options/rainfall_options.h"
#include "cli/options/study_file.h"
#include "cli/options/study_options.h"
#include "cli/options/view_options.h"
#include "cli/outputs/cell_features.h"
#include "cli/outputs/held_rain.h"
#include "cli/outputs/picture_of.h"
#include "cli/outputs/provenance_of.h"
#include "cli/outputs/rain_table.h"
#include "cli/outputs/report_of.h"
#include "cli/outputs/study_package_of.h"
#include "cli/outputs/summary.h"
#include "cli/terminal/line_width.h"
#include "cli/terminal/progress.h"
#include "rainfall/errors/mean_error.h"
#include "rainfall/series/gauge_readings.h"
#include "results/summary_file.h"
#include "results/weights_file.h"

namespace thiessen::cli {
namespace {

class RunCommand : public Command {
 public:
  RunCommand() {
    study_.declare(options(), Need::required);
    rainfall_.declare(options(), Need::required, study_.stations);
    gaps_.declare(options());
    format_.declare(options());
    periods_.declare(options());
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
           "which is also printed, report.html, a page with all of it for a browser, study.gpkg "
           "for "
           "a GIS, and the study.toml that repeats it";
  }
  const char* example() const override {
    return "samples/colorado/stations.csv samples/colorado/counties.geojson "
           "samples/colorado/rainfall.csv --basin-id name -o results";
  }
  void check() const override {
    periods_.check();
    format_.check(periods_.totalling().has_value());
    if (output_.output == "-") throw UsageError{"run writes a folder, not standard output", ""};
    study_.check();
    rainfall_.check();
    view_.check(true, true);
  }

  void run(Warnings& warnings) override {
    const unsigned threads = static_cast<unsigned>(common_.threads);
    const std::optional<StepTimes> times = periods_.times();
    check_picture_size(static_cast<int>(view_.size.width), static_cast<int>(view_.size.height));
    Outputs outputs(output_.rules(rainfall_.files_beside({study_.stations, study_.basins})));
    outputs.make_folder(output_.output);
    OutputFile& cells_file = outputs.add(output_.output + "/cells.geojson");
    OutputFile& weights_file = outputs.add(output_.output + "/weights.csv");
    OutputFile& rain_file = outputs.add(output_.output + "/rain.csv");
    OutputFile& map_file = outputs.add(output_.output + "/map.png");
    OutputFile& summary_file = outputs.add(output_.output + "/summary.csv");
    OutputFile& report_file = outputs.add(output_.output + "/report.html");
    OutputFile& package_file = outputs.add(output_.output + "/study.gpkg");
    outputs.add(output_.output + "/study.toml")
        .append(study_file_text(options(), name(), output_.output, warnings));

    Inputs inputs(study_, 0, rainfall_, common_.threads, warnings);
    const auto readings = inputs.open_readings(study_, rainfall_, warnings, times);
    periods_.settle_stamp(readings->stamp(), rainfall_.name());
    view_.units =
        unit_shown(readings->unit(), view_.units, view_.are_units_given(), rainfall_.name());
    ArealRainfallSettings settings = gaps_.settings();
    settings.accounts = format_.format().rows_for_basins && !periods_.totalling();
    const ArealRainfall rainfall(inputs.weighing(), settings, threads);
    write_weights(weights_file, inputs.weighing(), rainfall.full_weights(), inputs.area_unit());

    std::optional<Totalling> totalling = periods_.totalling();
    if (totalling) settle_rates(*totalling, inputs, study_, rainfall_, view_.units, warnings);
    RainTable series(rain_file, inputs.basins(), format_.format(), totalling, rainfall_.name());
    HeldRain held;
    series.tell(
        [&](const std::string& time, std::span<const double> values) { held.add(time, values); });
    MeanReadings means(inputs.network());
    MeanError error(rainfall, inputs.weighing());
    Summary summary(inputs, rainfall.full_weights());
    StudyReport report(inputs);
    {
      Progress progress("time step", common_.quiet,
                        [&](std::size_t done) { return readings->share_of(done); });
      for_each_step(
          *readings, rainfall, {threads}, [&](RainStep& step) { series.prepare(step); },
          [&](const RainStep& step) {
            series.add(step);
            means.add(step.readings);
            means.note(step.time, calendar_time(step.time, step.written));
            progress.advance();
            error.add(step.readings);
            summary.add(step);
            report.add(step);
          });
    }
    series.finish(warnings);
    GaugeReadings mean = means.of_all();
    if (rainfall_.is_event()) mean.label = rainfall_.event();
    if (rainfall.leaves_silent_out()) summary.find_most_influential(rainfall, threads);
    std::vector<double> errors = error.result(threads);
    summary.set_errors_of_mean(std::move(errors), error.shortfall());
    write_summary(summary_file, summary.basins(), inputs.area_unit());
    const auto cells = cells_of_network(inputs, threads);
    CellsOutput output = cells_output(inputs, cells, &mean, study_, view_.units);
    cells_file.append(cells_geojson(output, cells_file.name(), warnings));
    warn_of_new_names(output, cells_file.name(), warnings);
    warn_of_own_coordinates(inputs, cells_file.name(), warnings);
    const Picture picture = picture_of(inputs, cells, &mean, study_, view_);
    map_file.append(encode_picture(picture, PictureFormat::png, warnings));
    StudyPackage package = study_package_of(inputs, std::move(output),
                                            {.readings = &mean,
                                             .weights = &rainfall.full_weights(),
                                             .classes = classes_of(picture),
                                             .unit = view_.units,
                                             .interval = isohyets_.interval,
                                             .threads = threads});
    package.layers.basins = summary.basins();
    package.layers.has_series = true;
    if (held.is_too_long()) {
      warnings.add_notice({package_file.name(), 0,
                           "it has no table of the rainfall, which is of more than a million "
                           "values; rain.csv has them",
                           ""});
    }
    package.layers.rain = held.take();
    package_file.append(study_package(std::move(package), package_file.name(), "", warnings));
    report_file.append(report.page({.picture = &picture,
                                    .summary = &summary,
                                    .weights = &rainfall.full_weights(),
                                    .options = &options(),
                                    .made_by = provenance_of(inputs, study_, &mean, view_.units),
                                    .unit = view_.units},
                                   warnings));
    if (!common_.quiet) outputs.add("-").append(summary.text(view_.units, line_width()));
    outputs.commit();
  }
  bool quiet() const override { return common_.quiet; }

 private:
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
