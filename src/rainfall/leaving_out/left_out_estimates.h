#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "basin/basin.h"
#include "rainfall/leaving_out/left_out_weights.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/methods/squared_distances.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// How rainfall at a point is told.
enum class PointMethod : std::uint8_t { thiessen, arithmetic, idw, natural, linear };
inline constexpr std::array point_methods{PointMethod::thiessen, PointMethod::arithmetic,
                                          PointMethod::idw, PointMethod::natural,
                                          PointMethod::linear};
const char* name_of(PointMethod method);

/// Tells values at each place by all others, step by step.
///
/// - thiessen: the nearest (see NearestGauges);
/// - arithmetic: the mean of the others in the same basin, the first that holds the place; where
///   there is none, of all others;
/// - idw, natural, linear: the surface of surface_of without the place.
///
/// Cost of a step, for each place that reports: 0.1 microseconds, and that of LeftOutWeighing.
class LeftOutEstimates {
 public:
  /// The network must outlive it. `basins` are those in which means are taken.
  LeftOutEstimates(const Network& network, Metric metric, const std::vector<Basin>& basins);

  /// Has these places report from now on.
  void report(const ReportingPlaces& reports);
  /// Finds the weights that natural and linear share, which they else find when they are asked.
  void tessellate();
  /// Tells the value at each place that reports by the values of the others; NaN where nobody else
  /// reports. `values` and `told` have an entry for each place, and those that do not report are
  /// not looked at.
  void tell(PointMethod method, std::span<const double> values, std::span<double> told);

 private:
  struct Near {
    PlaceIndex place;
    double square;  ///< of the distance that idw weighs by
  };
  void keep_nearest(const std::vector<Point>& places);
  std::span<const Near> kept_at(std::size_t place) const {
    return std::span(near_).subspan(place * kept_, kept_);
  }
  void find_reporting(std::size_t place, std::size_t count);
  double nearest_value(std::size_t place, std::span<const double> values);
  double idw_value(std::size_t place, std::span<const double> values);
  double tessellated_value(PointMethod method, std::size_t place, std::span<const double> values);
  void tell_means(std::span<const double> values, std::span<double> told) const;

  const Network& network_;
  NearestGauges nearest_;
  SquaredDistances distances_;
  std::size_t kept_;
  std::vector<Near> near_;             // kept_ for each place, the nearest first
  std::vector<std::size_t> group_of_;  // by place: its basin, or the number of basins
  std::size_t groups_;
  LeftOutWeighing weighing_;
  ReportingPlaces reports_;
  bool is_tessellated_ = false;  // whether the tessellation is of those that report
  std::vector<NearestGauges::Near> searched_;
  std::vector<double> squares_;
  std::vector<Near> found_;
};

}  // namespace thiessen
