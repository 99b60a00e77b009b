#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/rainfall_options.h"
#include "cli/options/study_options.h"
#include "files/plane_judgement.h"
#include "files/study_files.h"
#include "rainfall/network/reporting.h"
#include "rainfall/series/dated_readings.h"
#include "rainfall/series/rain_series.h"
#include "rainfall/series/watched_readings.h"
#include "results/weights_file.h"
#include "study/study.h"

namespace thiessen::cli {

/// The inputs of a command, read and checked, with which every command begins.
class Inputs {
 public:
  /// Reads stations and basins. Without basins the extent of the stations, grown by `margin`
  /// percent, is the study area. Warns of a plane that moves weights. Throws Error.
  Inputs(const StudyOptions& options, double margin, std::size_t threads, Warnings& warnings);

  const StudyFiles& study() const { return *files_; }
  const Study& whole() const { return study_; }
  const Network& network() const { return study_.network(); }
  const Weighing& weighing() const { return study_.weighing(); }
  const std::vector<Basin>& basins() const { return study_.basins(); }
  bool has_basins() const { return files_->has_basins; }
  AreaUnit area_unit() const { return {study_.km2_per_area()}; }
  /// What the plane does to weights and areas; nothing where that is not known, or on the Earth.
  const std::optional<PlaneError>& plane_error() const { return plane_error_; }
  ReportingStations all_report() const { return study_.all_report(); }

  /// Opens RAINFALL; where times are wanted, only their steps are read from it. Any thread may ask
  /// it which share has been read. The inputs must outlive it.
  std::unique_ptr<WatchedReadings> open_readings(
      const StudyOptions& study, const RainfallOptions& rainfall, Warnings& warnings,
      const std::optional<StepTimes>& wanted = std::nullopt);

 private:
  std::shared_ptr<StudyFiles> files_;  // their stations have moved into the study's network
  std::vector<std::string> filtered_ids_;
  Study study_;
  std::optional<PlaneError> plane_error_;
};

}  // namespace thiessen::cli
