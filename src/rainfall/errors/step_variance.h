#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rainfall/errors/sites.h"
#include "rainfall/errors/variogram.h"

namespace thiessen {

/// The variance of the field at one step, from what its gauges read then.
struct FieldVariance {
  double variance;     ///< NaN: fewer than five gauges report, or all that do read the same
  double degrees;      ///< of freedom: of as many independent readings it would be as uncertain
  std::size_t gauges;  ///< that report, those of one place as one
};

/// What the difference of two gauges' readings is, squared, or is estimated to be.
struct SquaredDifference {
  std::uint32_t a;
  std::uint32_t b;
  double square;
};

/// Estimates the field's variance step by step from the differences of near gauges, each of which
/// has twice the variance times the variogram for its mean square: the mean of these ratios, with
/// the weight of a pair falling where the variogram is below a tenth of the mean, so that two
/// gauges a few metres apart do not decide.
///
/// The variance among all gauges would do too, divided by 1 less their mean correlation; but where
/// the field is smooth over the network it tells of a few waves only, as do 5 independent readings
/// where 30 gauges' differences tell as much as 20. Pairs: each gauge that reports and the three
/// nearest of its twelve nearest that do; where none of these does, the next along the order of the
/// sites. Cost of a step: 5 look-ups a gauge. Memory: 200 bytes a gauge.
class StepVariance {
 public:
  /// The sites and the variogram must outlive it. Cost: the nearest twelve of each; and, for the
  /// degrees of freedom, half a million look-ups.
  StepVariance(const Sites& sites, const Variogram& variogram);

  /// `readings`: one a site, NaN where it is silent. Safe for several threads at once.
  FieldVariance of(std::span<const double> readings) const;
  /// The same from differences of near gauges, `gauges` of them.
  FieldVariance of(std::span<const SquaredDifference> differences, std::size_t gauges) const;

  /// By what ratio the standard error must be widened, so that 1.96 of it to each side hold 95 %:
  /// Student's quantile over the normal one, by its series in 1 / degrees (M. Abramowitz, I. A.
  /// Stegun, 26.7.5), to 1 % from 3 degrees on; fewer than 2 count as 2.
  static double widening(double degrees);

 private:
  struct Near {
    std::uint32_t site;
    double semivariance;
  };
  struct Pair {
    std::uint32_t a;
    std::uint32_t b;
    double semivariance;
  };

  double degrees_of(std::size_t gauges) const;
  double weight(double semivariance) const { return 1 / (semivariance + floor_); }
  std::vector<Pair> pairs_of_all(std::size_t sites) const;
  double degrees_of_all() const;

  const Sites& sites_;
  const Variogram& variogram_;
  std::vector<std::size_t> first_;  // by site: where its near ones begin
  std::vector<Near> near_;
  double floor_ = 0;
  double degrees_ = 0;  // where all report
};

}  // namespace thiessen
