#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/options.h"
#include "files/study.h"
#include "rainfall/series/rain_series.h"
#include "rainfall/series/watched_readings.h"
#include "rainfall/weights.h"
#include "results/weights_file.h"

namespace thiessen::cli {

/// The inputs of a command, read and checked: what every command begins with.
class Session {
 public:
  /// Reads stations and basins. Without basins the stations' extent, grown by `margin` percent, is
  /// the study area. Throws Error.
  Session(const StudyOptions& options, double margin, Warnings& warnings);

  const Study& study() const { return study_; }
  const Network& network() const { return *network_; }
  const Weighing& weighing() const { return *weighing_; }
  const std::vector<Basin>& basins() const { return study_.basins; }
  bool has_basins() const { return has_basins_; }
  AreaUnit area_unit() const;
  std::vector<bool> all_report() const {
    return std::vector<bool>(network().stations().size(), true);
  }

  /// RAINFALL, opened, and of it the steps of the times that are wanted, if any are said. Any
  /// thread may ask it for the share that is read. The session must outlive it.
  std::unique_ptr<WatchedReadings> open_readings(
      const StudyOptions& study, const RainfallOptions& rainfall, Warnings& warnings,
      const std::optional<StepTimes>& wanted = std::nullopt);

 private:
  void add_extent_as_basin(double margin);
  void check_range() const;
  void warn_of_shared_places(Warnings& warnings) const;
  void warn_of_line(Warnings& warnings) const;

  Study study_;
  bool has_basins_;
  std::vector<std::string> filtered_ids_;
  std::unique_ptr<Network> network_;
  std::unique_ptr<Weighing> weighing_;
};

}  // namespace thiessen::cli
