#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include "rainfall/errors/sites.h"
#include "rainfall/errors/variogram.h"

namespace thiessen {

/// A gauge's site and its weight in a basin, or a change of that weight.
struct SiteWeight {
  std::uint32_t site;
  double weight;
};

/// The mean square error of a weighted sum of gauges as an estimate of one basin's mean, in units
/// of the field's variance.
///
/// For weights w that add up to 1 it is w'Rw - 2 w'r + r0. R holds the correlations between the
/// gauges, r the mean correlation of each gauge with the basin's points, and r0 is the mean
/// correlation of these points with each other. This is the block kriging variance of an estimator
/// whose weights are fixed (A. G. Journel, C. J. Huijbregts, Mining geostatistics, 1978, II.C).
///
/// It is computed as 2 w'g - w'Gw - g0, with the variogram in place of the correlation. The two are
/// equal, and only differences count in the second. The nugget stands in G off its diagonal, and in
/// g and g0 in full: a gauge's own error does not average out at the other gauges, and the basin's
/// mean has no such error.
///
/// The basin is represented by `points` of equal weight. Each stands for a square, so its mean
/// distance from itself is 0.5214 of the square's side.
///
/// The terms of each gauge with the full network's weights and with the points are remembered once
/// the gauge has come to weigh, so that changed weights cost the square of their number. Safe for
/// several threads at once. Memory: 24 bytes a point, and 40 to 80 bytes for each gauge that has
/// come to weigh, up to a few thousand gauges.
class BasinError {
 public:
  /// `full` are the full network's weights, in the order of their sites. `side_of_point` is the
  /// side of the square that a point stands for, in the unit of distances. Sites and variogram must
  /// outlive this object. Cost: the number of weights and points, times the number of points.
  BasinError(std::vector<SiteWeight> full, std::vector<Direction> points, double side_of_point,
             const Sites& sites, const Variogram& variogram);
  /// The same basin by other weights of the full network. Cost: what the gauges cost that are not
  /// in the first weights, and the square of the number of weights.
  BasinError(const BasinError& like, std::vector<SiteWeight> full);

  /// How many points stand for the basin.
  std::size_t points() const { return points_->size(); }

  /// The mean square error once `change` is added to the full network's weights and all are divided
  /// by their sum. Requires a change in the order of its sites, each site once. The result is never
  /// below 0. Accuracy: 1e-12 of the variogram at the basin's width.
  double mean_square(std::span<const SiteWeight> change) const;

 private:
  /// The variogram of one gauge, summed over the full network's gauges and averaged over the
  /// points.
  struct Terms {
    double with_weights;  // the variogram to the full network's gauges, by their weights
    double with_points;   // the mean variogram to the basin's points
  };

  Terms terms_of(std::uint32_t site) const;
  double with_weights(std::uint32_t site) const;
  double with_points(std::uint32_t site) const;
  void sum_up();
  std::vector<Terms> terms_of(std::span<const SiteWeight> change) const;
  double within_points(double side_of_point) const;

  const Sites& sites_;
  const Variogram& variogram_;
  std::vector<SiteWeight> full_;
  std::shared_ptr<const std::vector<Direction>> points_;
  std::vector<Terms> terms_;  // of the full network's gauges, in the order of full_
  double weights_weights_ = 0;
  double weights_points_ = 0;
  double points_points_ = 0;
  mutable std::mutex mutex_;
  mutable std::unordered_map<std::uint32_t, Terms> others_;
};

}  // namespace thiessen
