#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "rainfall/gaps/kept.h"
#include "rainfall/gaps/remembered.h"
#include "rainfall/methods/area_method.h"
#include "rainfall/methods/natural_weights.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/methods/point_blocks.h"
#include "rainfall/methods/weight_sums.h"
#include "rainfall/network/weights.h"

namespace thiessen {

/// Sibson's natural neighbour interpolation (see NaturalWeights), averaged over `points` points of
/// a basin. A point outside the gauges' hull has the value of the nearest gauge (see
/// NearestGauges).
///
/// The points of a basin are kept in blocks that have the same neighbours in the full network, each
/// with the sums of their weights, which hold as long as all of these report. Where one or two are
/// silent a block's sums are found in the tessellation without them alone, and remembered: where
/// these sums weigh silent gauges, too, they are found without all of them. So they depend on few
/// gauges, which fall silent together again and again where whole sets never do. Where more are
/// silent they are found in the tessellation without all silent gauges. Gauges are deleted and
/// taken back afterwards; only of gauges all round the Earth is a tessellation made anew, where the
/// gauge at infinity is silent, or the others no longer stand all round (see GaugeChart); there
/// nothing is remembered. Memory: 60 bytes a point, 250 bytes a block, of which there are some 15
/// in the cell of a gauge, and a copy of the tessellation for each thread. Cost: 0.5 microseconds a
/// point, once; then, for each set of reporting gauges, as much for each point of a block next to
/// silent gauges whose sums are not remembered, and a look at every block of the basins that have
/// such points.
class NaturalNeighbours : public AreaMethod {
 public:
  static constexpr const char* name = "natural";

  /// The weighing must outlive this object. `remembered_bytes` bounds the sums that are remembered;
  /// weights do not depend on it.
  NaturalNeighbours(const Weighing& weighing, std::size_t points, unsigned threads,
                    std::size_t remembered_bytes = std::size_t{64} << 20);
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
  /// The points of a basin, block by block.
  struct Points {
    std::vector<Point> positions;
    std::vector<ChartPoint> at;
    std::vector<std::vector<double>> normals;  ///< see point_normals
    PointBlocks blocks;
    std::vector<std::vector<PlaceWeight>> full;  ///< by month, as the normals
    std::vector<PlaceIndex> all;  ///< places that are a neighbour of any of the points
  };
  /// The neighbours of points; those of the i-th begin at first[i].
  struct Found {
    std::vector<std::uint32_t> first{0};
    std::vector<Neighbour> neighbours;

    std::span<const Neighbour> of(std::size_t i) const {
      return std::span(neighbours).subspan(first[i], first[i + 1] - first[i]);
    }
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
  using Sums = std::vector<PlaceSum>;
  /// What one thread works with: a copy of the tessellation, and memory that is used again.
  class Workplace;
  /// The sums of blocks at a step.
  class AtStep;

  std::size_t keep_neighbours(Points& points, Workplace& workplace) const;
  static void add(const Points& points, std::size_t month, std::size_t point,
                  std::span<const Neighbour> neighbours, WeightSums& sums);
  static void weigh_all(Points& points, const Found& found, WeightSums& sums);
  static void put_in_blocks(Points& points, const Found& found, WeightSums& sums);
  std::unique_ptr<Workplace> borrow() const;
  void give_back(std::unique_ptr<Workplace> workplace) const;

  const Weighing& weighing_;
  NearestGauges nearest_;
  Gauges full_;
  std::vector<Points> points_;  // by basin
  std::vector<double> shares_outside_;
  std::vector<std::size_t> first_sum_;           // by basin: of all sums of all months
  mutable std::unique_ptr<Kept<Sums>> singles_;  // by sum: those of its block without its place
  mutable Remembered<std::uint32_t, Sums> remembered_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Workplace>> idle_;
};

}  // namespace thiessen
