#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "earth/geodesic.h"
#include "rainfall/methods/area_method.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/methods/weight_sums.h"
#include "rainfall/weights.h"

namespace thiessen {

/// Inverse distance squared: at a point each of the 12 nearest gauges that report weighs as 1 / d^2
/// (all where there are fewer), and a gauge at the point has all the weight (D. Shepard, A
/// two-dimensional interpolation function for irregularly-spaced data, 1968); the mean over
/// `points` points of a basin.
///
/// Distances are in the plane, or geodesics on WGS 84 to 1e-7 of themselves. For each point its 24
/// nearest gauges are kept, so that those that are silent have others in their stead; where that is
/// not enough the rest are looked for. Accuracy: 1e-7 of each weight, for they are kept as floats.
/// Memory: 210 bytes a point. Cost: 2.5 microseconds a point, once; then for each set of reporting
/// gauges 50 nanoseconds a point of the basins that a silent gauge weighs in.
class InverseDistance : public AreaMethod {
 public:
  static constexpr const char* name = "idw";

  static constexpr std::size_t neighbours = 12;

  /// The weighing must outlive it.
  InverseDistance(const Weighing& weighing, std::size_t points, unsigned threads);
  Weights weights(const ReportingPlaces& reports) const override;

 private:
  static constexpr std::size_t kept = 24;

  /// A gauge near a point.
  struct Neighbour {
    PlaceIndex place;
    float weight;  ///< the square of the nearest one's distance by that of this; infinite at it
  };
  /// The points of a basin.
  struct Points {
    std::vector<Point> at;
    std::vector<Neighbour> near;  ///< for each point so many as are kept, the nearest first
    std::vector<PlaceWeight> full;
  };

  void keep_neighbours(Points& points) const;
  void weigh(Point at, std::span<const NearestGauges::Near> near,
             std::span<Neighbour> weighed) const;
  std::vector<PlaceWeight> weights_of(const Points& points, const ReportingPlaces& reports,
                                      WeightSums& sums) const;
  std::span<const Neighbour> kept_at(const Points& points, std::size_t i) const {
    return std::span(points.near).subspan(i * kept_, kept_);
  }

  const Weighing& weighing_;
  std::vector<EarthPoint> on_earth_;  // the places, where the metric is geodesic
  NearestGauges nearest_;
  std::size_t kept_;
  std::vector<Points> points_;  // by basin
};

}  // namespace thiessen
