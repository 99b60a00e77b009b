#include "cli/inputs/inputs.h"

#include <utility>

#include "files/rainfall_file.h"
#include "rainfall/series/watched_readings.h"

namespace thiessen::cli {

Inputs::Inputs(const StudyOptions& options, double margin, std::size_t threads, Warnings& warnings)
    : files_(std::make_shared<StudyFiles>(read_study(options.request(), warnings))),
      filtered_ids_(files_->filtered_ids.begin(), files_->filtered_ids.end()),
      study_(files_, {margin, options.tolerance(), options.allow_far()}, warnings),
      plane_error_(judge_plane(*files_, study_, options.tolerance(), static_cast<unsigned>(threads),
                               warnings)) {}

std::unique_ptr<WatchedReadings> Inputs::open_readings(const StudyOptions& study,
                                                       const RainfallOptions& rainfall,
                                                       Warnings& warnings,
                                                       const std::optional<StepTimes>& wanted) {
  ReadingsOptions options = rainfall.readings(study.decimal_comma());
  options.column_of = [request = study.request().stations](const std::string& id) {
    return field_that_holds(request, id);
  };
  auto readings = open_rainfall(rainfall.rainfall, study.separator(), network().stations(),
                                filtered_ids_, options, warnings);
  if (wanted) {
    readings =
        std::make_unique<DatedReadings>(std::move(readings), rainfall.name(), *wanted, warnings);
  }
  return std::make_unique<WatchedReadings>(std::move(readings));
}

}  // namespace thiessen::cli
