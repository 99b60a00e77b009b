#include "cli/inputs/fitted_normals_of.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "cli/options/usage_error.h"
#include "files/normals/elevation_study.h"
#include "files/rainfall/rainfall_file.h"
#include "rainfall/errors/rainfall_error.h"
#include "rainfall/leaving_out/left_out_readings.h"
#include "rainfall/network/mean_reading.h"
#include "rainfall/normals/calendar_normals.h"
#include "rainfall/series/step_months.h"
#include "rainfall/series/step_sample.h"

namespace thiessen::cli {
namespace {

std::string option_of(const StudyOptions& study) {
  return study.elevation().empty() ? "--elevation-field" : "--elevation";
}

void require_series(const StudyOptions& study, const RainfallOptions& rainfall) {
  const std::string option = option_of(study);
  if (!rainfall.given()) {
    throw UsageError{option + " fits normals to RAINFALL, and there is none",
                     "give RAINFALL; --normals and --normal-field take normals that are known"};
  }
  if (rainfall.is_event()) {
    throw UsageError{
        option + " fits normals to a series, and --value-field names one event's field",
        "--normals and --normal-field take normals that are known"};
  }
  if (rainfall.is_standard_input()) {
    throw UsageError{option + " reads RAINFALL twice, and standard input can be read once",
                     "give a file"};
  }
  if (!can_be_read_again(rainfall.request({}))) {
    throw UsageError{
        option + " reads RAINFALL twice, and " + printable(rainfall.name()) + " is not a file",
        "give a file"};
  }
}

/// The month of a year in which a step lies, where its time tells one.
std::optional<MonthOfYear> month_of_year(const TimeStep& step, Stamp stamp) {
  const auto month = month_of(step.time, step.written, stamp);
  const auto year = year_of(step.time, step.written, stamp);
  if (!month || !year) return std::nullopt;
  return MonthOfYear{*year, *month};
}

/// What is kept of RAINFALL while it is read for its normals: a sample of its steps, in which each
/// gauge is left out afterwards.
class SeriesRead {
 public:
  explicit SeriesRead(const Network& network)
      : network_(network),
        normals_(network.places().size()),
        sample_(network.stations().size(), steps_for_errors(network.stations().size())) {}

  void read(Readings& readings, Stamp stamp) {
    for (TimeStep step; readings.next(step);) {
      throw_if_interrupted();
      const auto when = month_of_year(step, readings.stamp().value_or(stamp));
      normals_.add(readings_by_place(network_, step.readings), when);
      months_.push_back(when ? NormalMonth(when->month) : NormalMonth());
      sample_.add(step.readings);
    }
    unit_ = readings.unit();
  }

  const CalendarNormals& normals() const { return normals_; }
  std::string left_out(const Inputs& inputs, const std::vector<double>& elevations) const {
    const NormalField* const normals = inputs.weighing().normals();
    LeftOutReadings left_out(network_, inputs.weighing().yardstick().metric, normals,
                             ElevationBands(elevations));
    for (std::size_t i = 0; i < sample_.steps(); ++i) {
      const NormalMonth month =
          normals->months() == 1 ? NormalMonth() : months_[i * sample_.spacing()];
      left_out.add(sample_[i], month);
    }
    return left_out_text(left_out, unit_) +
           (sample_.spacing() == 1
                ? ""
                : " (one step in " + std::to_string(sample_.spacing()) + " was tried)");
  }

 private:
  const Network& network_;
  CalendarNormals normals_;
  StepSample sample_;
  std::vector<NormalMonth> months_;  // by step of the series
  std::string unit_;
};

}  // namespace

std::vector<double> fit_normals(Inputs& inputs, const StudyOptions& study,
                                const RainfallOptions& rainfall, const NormalFitting& fitting,
                                Warnings& warnings) {
  if (!study.fits_normals()) return {};
  require_series(study, rainfall);
  SeriesRead series(inputs.network());
  {
    Warnings told_later;
    series.read(*inputs.open_readings(study, rainfall, told_later), fitting.stamp);
  }
  const ElevationRequest request{.raster = study.elevation(),
                                 .is_field_named = !study.elevation_field().empty(),
                                 .rainfall = rainfall.name(),
                                 .threads = static_cast<unsigned>(fitting.threads)};
  ElevationStudy fitted =
      normals_by_elevation(request, inputs.whole(), inputs.study(), series.normals(), warnings);
  inputs.take_normals(std::move(fitted.normals));
  warnings.add_notice({rainfall.name(), 0, series.left_out(inputs, fitted.elevations), ""});
  return std::move(fitted.elevations);
}

}  // namespace thiessen::cli
