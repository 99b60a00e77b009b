#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "earth/sphere/geodesic.h"
#include "rainfall/methods/area_method.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/methods/point_blocks.h"
#include "rainfall/methods/weight_sums.h"
#include "rainfall/network/weights.h"

namespace thiessen {

/// Inverse distance weighting with the square of the distance, averaged over `points` points of a
/// basin.
///
/// At a point each of the 12 nearest gauges that report has a weight in proportion to 1 / d^2 (all
/// gauges where there are fewer). A gauge at the point itself has all the weight. Source: D.
/// Shepard, A two-dimensional interpolation function for irregularly-spaced data, 1968.
///
/// Distances are those of the plane, or geodesics on WGS 84 to 1e-7 of their length. The 24 nearest
/// gauges of each point are kept, so that others can stand in for silent ones; where 24 are too few
/// the rest of the network is searched. Accuracy: 1e-7 of each weight, for weights are kept as
/// floats. Memory: 230 bytes a point. Cost: 2.5 microseconds a point, once; then, for each set of
/// reporting gauges, 50 nanoseconds for each point of a block next to a silent gauge. Blocks are
/// points with the same 12 nearest gauges, and the sums of their weights hold as long as all of
/// these report.
class InverseDistance : public AreaMethod {
 public:
  static constexpr const char* name = "idw";

  static constexpr std::size_t neighbours = 12;

  /// The weighing must outlive this object.
  InverseDistance(const Weighing& weighing, std::size_t points, unsigned threads);
  Weights weights(const ReportingPlaces& reports, const NormalMonth& month) const override;
  using AreaMethod::weights;

 private:
  static constexpr std::size_t kept = 24;

  /// A gauge near a point.
  struct Neighbour {
    PlaceIndex place;
    float weight;  ///< (the nearest gauge's distance / its own)^2; infinite at the point
  };
  /// The points of a basin, block by block, and the gauges near them.
  struct Points {
    std::vector<Point> at;
    std::vector<Neighbour> near;               ///< kept_ for each point, the nearest first
    std::vector<std::vector<double>> normals;  ///< see point_normals
    PointBlocks blocks;
    std::vector<std::vector<PlaceWeight>> full;  ///< by month, as the normals
  };
  /// What it takes to find points' gauges; its memory is used again.
  struct Bench {
    explicit Bench(std::size_t places) : sums(places) {}

    WeightSums sums;
    std::vector<NearestGauges::Near> near;
  };

  void keep_neighbours(Points& points) const;
  void put_in_blocks(Points& points, const ReportingPlaces& all, Bench& bench) const;
  void weigh(Point at, std::span<const NearestGauges::Near> near,
             std::span<Neighbour> weighed) const;
  void add(const Points& points, std::size_t month, std::size_t point,
           const ReportingPlaces& reports, Bench& bench) const;
  std::vector<PlaceWeight> weights_of(const Points& points, std::size_t month,
                                      const ReportingPlaces& reports, Bench& bench) const;
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
