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
#include "rainfall/weights.h"

namespace thiessen {

/// Sibson's natural neighbours (see NaturalWeights), the mean over `points` points of a basin;
/// outside the gauges' hull the nearest gauge (see NearestGauges).
///
/// For each point its neighbours in the full network are kept, and its weights are those as long as
/// all of them report. The others are found again, in the tessellation without the silent gauges,
/// which are deleted and taken back. Memory: 170 bytes a point, and for each thread a copy of the
/// tessellation. Cost: 0.5 microseconds a point, once; then for each set of reporting gauges as
/// much for each point next to a silent one, and a look at the points of the basins that have any.
class NaturalNeighbours : public AreaMethod {
 public:
  static constexpr const char* name = "natural";

  /// The weighing must outlive it.
  NaturalNeighbours(const Weighing& weighing, std::size_t points, unsigned threads);
  ~NaturalNeighbours() override;
  Weights weights(const ReportingPlaces& reports) const override;

  /// By basin, the share of its points outside the full network's hull.
  const std::vector<double>& shares_outside() const { return shares_outside_; }

 private:
  /// The points of a basin; those of the i-th begin at first[i] in `neighbours`.
  struct Points {
    std::vector<Point> positions;
    std::vector<ChartPoint> at;
    std::vector<std::uint32_t> first{0};
    std::vector<PlaceWeight> neighbours;
    std::vector<PlaceWeight> full;
    std::vector<PlaceIndex> all;  ///< that are a neighbour of any of the points
  };
  /// What a thread works with.
  class Workplace;

  std::size_t keep_neighbours(Points& points, Workplace& workplace) const;
  std::vector<PlaceWeight> weights_of(const Points& points, const ReportingPlaces& reports,
                                      Workplace& workplace) const;
  std::unique_ptr<Workplace> borrow() const;
  void give_back(std::unique_ptr<Workplace> workplace) const;

  const Weighing& weighing_;
  GaugeChart chart_;
  NearestGauges nearest_;
  std::unique_ptr<const NaturalWeights> natural_;   // of the full network
  std::vector<std::vector<PlaceIndex>> places_of_;  // by the tessellation's number: one, but where
                                                    // rounding does not tell them apart
  std::vector<Points> points_;                      // by basin
  std::vector<double> shares_outside_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Workplace>> idle_;
};

}  // namespace thiessen
