#pragma once

#include <cstdint>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include "rainfall/errors/sites.h"
#include "rainfall/errors/variogram.h"

namespace thiessen {

/// A gauge's site and its weight in a basin, or what is added to it.
struct SiteWeight {
  std::uint32_t site;
  double weight;
};

/// How far weighted gauges are off the mean of one basin: the mean square of the error, in units of
/// the field's variance.
///
/// With weights w that add up to 1 it is w'Rw - 2 w'r + r0: R being the correlations of the gauges,
/// r theirs with the basin's points, in the mean, and r0 that of its points with each other: the
/// block kriging variance of an estimator whose weights are fixed (A. G. Journel, C. J.
/// Huijbregts, Mining geostatistics, 1978, II.C). It is computed as 2 w'g - w'Gw - g0 with the
/// variogram in place of the correlation, which is the same, so only differences count. The nugget
/// stands in G, off its diagonal, and in g and g0 in full: a gauge's own error does not average out
/// at the other gauges, and the basin's mean has none.
///
/// The basin is `points` of equal weight, and each of them stands for a square: its mean distance
/// from itself is 0.5214 of the square's side.
///
/// Remembers what each gauge that comes to weigh has with the full network's weights and with the
/// points, so that changed weights cost their number squared. Safe for several threads at once.
/// Memory: 24 bytes a point, 40 to 80 bytes a gauge that has come to weigh, up to a few thousand.
class BasinError {
 public:
  /// `full`: the full network's weights, by site. `side_of_point`: the side, in the unit of
  /// distances, of the ground that a point stands for. Sites and variogram must outlive it. Cost:
  /// the weights and the points, times the points.
  BasinError(std::vector<SiteWeight> full, std::vector<Direction> points, double side_of_point,
             const Sites& sites, const Variogram& variogram);

  /// Where `change` is added to the full network's weights and all are divided by their sum; by
  /// site, each once. Not below 0. Accuracy: 1e-12 of the variogram at the basin's width.
  double mean_square(std::span<const SiteWeight> change) const;

 private:
  /// What a gauge has with the full network's weights and with the points, in the mean.
  struct Terms {
    double with_weights;
    double with_points;
  };

  Terms terms_of(std::uint32_t site) const;
  std::vector<Terms> terms_of(std::span<const SiteWeight> change) const;
  double within_points(double side_of_point) const;

  const Sites& sites_;
  const Variogram& variogram_;
  std::vector<SiteWeight> full_;
  std::vector<Direction> points_;
  std::vector<Terms> terms_;  // of the full network's
  double weights_weights_ = 0;
  double weights_points_ = 0;
  double points_points_ = 0;
  mutable std::mutex mutex_;
  mutable std::unordered_map<std::uint32_t, Terms> others_;
};

}  // namespace thiessen
