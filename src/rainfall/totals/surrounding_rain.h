#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "earth/sphere/geodesic.h"
#include "geometry/direction.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/network/network.h"
#include "rainfall/network/reporting.h"
#include "rainfall/network/weights.h"
#include "rainfall/normals/normal_field.h"

namespace thiessen {

/// The rain around a place as the nearest gauges that report had it at a step.
///
/// It is the mean of the 8 nearest places that report, each with a weight in proportion to 1 / d^2
/// (Shepard 1968); of all where there are fewer. A place at distance 0 has all the weight. A place
/// of several gauges has the mean of those that report. With normals it is the mean of readings
/// relative to the gauges' normals, times the normal at the gauge that stands there. Of equally
/// near places the one with the lesser coordinates comes first. Distances are those of the plane,
/// or geodesics on WGS 84.
///
/// The 32 nearest places of those that have reported so far are kept for each place that is asked
/// for, and up to 512 where fewer than 8 of these report; beyond these the network is searched.
/// Cost: 50 nanoseconds a place and step, and 30 microseconds a place once.
class SurroundingRain {
 public:
  static constexpr std::size_t most = 8;

  /// The weighing must outlive this object.
  explicit SurroundingRain(const Weighing& weighing);

  /// What fell at each place at a step, relative to its gauges' normals; NaN where no gauge
  /// reports. `readings` has one entry a station. Has to be called for a step before `at` is asked
  /// of it.
  std::vector<double> by_place(std::span<const double> readings, const NormalMonth& month);
  /// The rain around a gauge at a step of which `by_place` said what fell; NaN where no gauge
  /// reports.
  double at(StationIndex gauge, std::span<const double> by_place, const NormalMonth& month);

 private:
  static constexpr std::size_t kept = 32;
  static constexpr std::size_t kept_at_most = 512;

  struct Neighbour {
    PlaceIndex place;
    double square;  ///< of the straight distance, by which places are ranked
    double weight;  ///< 1 / d^2; infinite at distance 0
  };
  struct Neighbourhood {
    std::vector<Neighbour> near;  ///< the nearest first
    std::size_t wanted = kept;    ///< how many of them there are, if that many have reported
    std::size_t of = 0;           ///< how many places had reported when it was brought up to date
  };

  const Neighbourhood& around(PlaceIndex place);
  void find(PlaceIndex place, Neighbourhood& here);
  void insert(PlaceIndex place, PlaceIndex fresh, Neighbourhood& here) const;
  Neighbour neighbour(PlaceIndex of, PlaceIndex place, double square) const;
  double searched(PlaceIndex from, std::span<const double> by_place);
  std::vector<double> means_by_place(std::span<const double> readings, const NormalMonth& month);

  const Weighing& weighing_;
  NearestGauges nearest_;
  std::vector<Direction> in_space_;   ///< the places
  std::vector<EarthPoint> on_earth_;  ///< the same, where the metric is geodesic
  ReportingPlaces have_reported_;
  std::vector<PlaceIndex> reporters_;          ///< those that have, in their order
  std::vector<PlaceIndex> have_not_;           ///< those that have not
  std::vector<Neighbourhood> neighbourhoods_;  ///< by place
  std::vector<NearestGauges::Near> found_;
  std::vector<std::size_t> counts_;  ///< by place: how many of its gauges report at a step
};

}  // namespace thiessen
