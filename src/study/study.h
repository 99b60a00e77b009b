#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "base/error.h"
#include "rainfall/network/network.h"
#include "rainfall/network/reporting.h"
#include "rainfall/network/weights.h"
#include "study/nearest_gauges.h"
#include "study/study_parts.h"

namespace thiessen {

/// The numbers that a setting may have, both ends among them. A study can be computed with all in
/// the ranges below, and the program takes the same.
struct SettingRange {
  double low;
  double high;
  bool holds(double value) const { return value >= low && value <= high; }
};
inline constexpr SettingRange tolerances{1e-3, 1e6};  ///< metres
inline constexpr SettingRange margins{0, 1000};       ///< percent
/// How long a plane's unit may be, in metres: its square has to stay an area.
inline constexpr SettingRange plane_units{1e-9, 1e9};

/// Settings of a study beside its stations and basins.
struct StudySettings {
  double margin = 0;       ///< percent by which the extent is grown where there are no basins
  double tolerance = 0.1;  ///< metres that an edge of a cell may lie from the true one
  /// Whether gauges and basins may be nowhere near each other: see judge_nearness.
  bool allow_far = false;
};

/// A study in memory: a network of gauges, and basins in which they are weighed. It owns its parts.
class Study {
 public:
  /// Moves the stations of `parts` into the network. Without basins the extent of the stations
  /// becomes the only study area. Warns of stations that share a place, of a network on one
  /// line, and of basins far from every gauge. Throws Error with every coordinate outside the exact
  /// range of predicates.h, where stations without extent make no study area, where gauges and
  /// basins are nowhere near each other, and where coordinates are so large that their digits do
  /// not tell places in a basin apart (judge_digits). Cost: n log n.
  Study(std::shared_ptr<StudyParts> parts, const StudySettings& settings, Warnings& warnings);
  Study(const Study&) = delete;
  Study& operator=(const Study&) = delete;

  const StudyParts& parts() const { return *parts_; }
  const Network& network() const { return network_; }
  const Weighing& weighing() const { return weighing_; }
  /// Has gauges weighed with these normals from now on; see Weighing::take_normals.
  void take_normals(std::shared_ptr<const NormalField> normals) {
    weighing_.take_normals(std::move(normals));
  }
  const std::vector<Basin>& basins() const { return parts_->basins; }
  /// The nearest gauge of each basin; none where there are no basins. Cost: that of
  /// nearest_gauges.
  std::vector<NearestGauge> nearest_gauges() const;
  /// How many square kilometres one unit of the weighing's areas is; 1 where the length of the
  /// plane's unit is unknown, so that areas are shown as they are.
  double km2_per_area() const {
    const bool known = parts_->metric == Metric::geodesic || parts_->metres_per_unit.has_value();
    return known ? 1e-6 : 1.0;
  }
  ReportingStations all_report() const {
    return ReportingStations(network_.stations().size(), true);
  }

 private:
  void warn_of_shared_places(Warnings& warnings) const;
  void warn_of_line(Warnings& warnings) const;

  std::shared_ptr<StudyParts> parts_;
  Network network_;
  Weighing weighing_;
};

}  // namespace thiessen
