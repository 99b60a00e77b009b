#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/options/blocks/rainfall_options.h"
#include "cli/options/blocks/study_options.h"
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
  /// percent, is the study area. All stations are of the network. Warns of a plane that moves
  /// weights. Takes the normals that the options name, but for those that are fitted: see
  /// fit_normals. Throws Error.
  Inputs(const StudyOptions& options, double margin, std::size_t threads, Warnings& warnings);
  /// The same, with the full network: the stations with at least one reading in RAINFALL. Where
  /// RAINFALL is not given, or can be read only once, all stations are, and a notice says so.
  Inputs(const StudyOptions& options, double margin, const RainfallOptions& rainfall,
         std::size_t threads, Warnings& warnings);
  /// The same of a study that has been read, of which all stations are the network.
  Inputs(std::shared_ptr<StudyFiles> files, const StudyOptions& options, double margin,
         std::size_t threads, Warnings& warnings);

  const StudyFiles& study() const { return *files_; }
  const Study& whole() const { return study_; }
  const Network& network() const { return study_.network(); }
  /// The stations of the file that have no reading, and are not of the network.
  const std::vector<Station>& never_reporting() const { return files_->never_reporting; }
  const Weighing& weighing() const { return study_.weighing(); }
  const std::vector<Basin>& basins() const { return study_.basins(); }
  bool has_basins() const { return files_->has_basins; }
  AreaUnit area_unit() const { return {study_.km2_per_area()}; }
  /// What the plane does to weights and areas; nothing where that is not known, or on the Earth.
  const std::optional<PlaneError>& plane_error() const { return plane_error_; }
  ReportingStations all_report() const { return study_.all_report(); }
  /// Has gauges weighed with these normals from now on; see Weighing::take_normals.
  void take_normals(std::shared_ptr<const NormalField> normals) {
    study_.take_normals(std::move(normals));
  }

  /// Opens RAINFALL; where times are wanted, only their steps are read from it. Any thread may ask
  /// it which share has been read. Where there are totals beside RAINFALL they are spread over its
  /// steps, whose times are such stamps, those of the options where none is given. The inputs must
  /// outlive it.
  std::unique_ptr<WatchedReadings> open_readings(
      const StudyOptions& study, const RainfallOptions& rainfall, Warnings& warnings,
      const std::optional<StepTimes>& wanted = std::nullopt,
      std::optional<Stamp> stamp = std::nullopt);

 private:
  std::shared_ptr<StudyFiles> files_;     // their stations have moved into the study's network
  std::vector<std::string> passed_over_;  // ids whose readings are passed over in silence
  Study study_;
  std::optional<PlaneError> plane_error_;
};

/// Leaves in a study that has been read the full network alone: the stations with at least one
/// reading in RAINFALL. Where RAINFALL is not given, or can be read only once, all stations stay,
/// and a notice says so.
void keep_full_network(StudyFiles& files, const StudyOptions& options,
                       const RainfallOptions& rainfall, Warnings& warnings);

/// Gives the notice that all stations are taken for the network, for there is no RAINFALL.
void note_whole_network(const Inputs& inputs, Warnings& warnings);

}  // namespace thiessen::cli
