#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "rainfall/methods/area_method.h"
#include "rainfall/methods/natural_weights.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/methods/weight_sums.h"
#include "rainfall/network/weights.h"

namespace thiessen {

/// Sibson's natural neighbour interpolation (see NaturalWeights), averaged over `points` points of
/// a basin. A point outside the gauges' hull has the value of the nearest gauge (see
/// NearestGauges).
///
/// For each point the neighbours in the full network are kept; its weights hold as long as all of
/// these report. For the other points they are found again in the tessellation without the silent
/// gauges, which are deleted from it and taken back afterwards. Only of gauges all round the Earth
/// is one made anew, where the gauge at infinity is silent, or the others no longer stand all round
/// (see GaugeChart). Memory: 170 bytes a point, and a
/// copy of the tessellation for each thread. Cost: 0.5 microseconds a point, once; then, for each
/// set of reporting gauges, as much for each point next to a silent gauge, and a look at every
/// point of the basins that have such points.
class NaturalNeighbours : public AreaMethod {
 public:
  static constexpr const char* name = "natural";

  /// The weighing must outlive this object.
  NaturalNeighbours(const Weighing& weighing, std::size_t points, unsigned threads);
  ~NaturalNeighbours() override;
  Weights weights(const ReportingPlaces& reports, const NormalMonth& month) const override;
  using AreaMethod::weights;

  /// The share of each basin's points that lie outside the full network's hull.
  const std::vector<double>& shares_outside() const { return shares_outside_; }

 private:
  /// What a place weighs at a point.
  struct Neighbour {
    PlaceIndex place;
    double weight;
  };
  /// The points of a basin. The neighbours of the i-th point begin at first[i] in `neighbours`.
  struct Points {
    std::vector<Point> positions;
    std::vector<ChartPoint> at;
    std::vector<std::uint32_t> first{0};
    std::vector<Neighbour> neighbours;
    std::vector<std::vector<double>> normals;    ///< see point_normals
    std::vector<std::vector<PlaceWeight>> full;  ///< by month, as the normals
    std::vector<PlaceIndex> all;  ///< places that are a neighbour of any of the points
  };
  /// The tessellation of some places, by its numbers: a number stands for one place, or for several
  /// that rounding cannot tell apart.
  struct Gauges {
    Gauges(const std::vector<Point>& positions, const std::vector<PlaceIndex>& places,
           Metric metric);

    GaugeChart chart;
    NaturalWeights natural;
    std::vector<std::vector<PlaceIndex>> places_of;  // by number
  };
  /// What one thread works with: a copy of the tessellation, and memory that is used again.
  class Workplace;

  std::size_t keep_neighbours(Points& points, Workplace& workplace) const;
  std::vector<PlaceWeight> weights_of(const Points& points, std::size_t month,
                                      const ReportingPlaces& reports, Workplace& workplace) const;
  std::unique_ptr<Workplace> borrow() const;
  void give_back(std::unique_ptr<Workplace> workplace) const;

  const Weighing& weighing_;
  NearestGauges nearest_;
  Gauges full_;
  std::vector<Points> points_;  // by basin
  std::vector<double> shares_outside_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Workplace>> idle_;
};

}  // namespace thiessen
