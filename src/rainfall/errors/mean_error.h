#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/sites.h"
#include "rainfall/errors/step_variance.h"
#include "rainfall/series/step_sample.h"
#include "rainfall/weights.h"

namespace thiessen {

class RainfallError;

/// The standard error of the mean rainfall over a series, by basin, in one pass.
///
/// As RainfallError has it of one step, but with the variance that near gauges' mean differences
/// tell, over the steps that both report: so what cancels from step to step cancels here, and what
/// lasts does not. Two gauges count where they report together at half as many steps or more as the
/// two that do so most often. What of the mean differences' squares the scatter of single steps
/// explains, were steps independent, comes and goes: it counts with the mean square for the weights
/// of a step, in the mean over a sample of them. The rest lasts, and counts with that for the mean
/// of these weights: where now this gauge is silent and now that, its error cancels in part.
///
/// Cost of a step: six differences a gauge. In the end: RainfallError's, and a hundred of its
/// steps. Memory: 100 bytes a gauge, and the sample.
class MeanError {
 public:
  /// The rainfall and the weighing must outlive it.
  MeanError(const ArealRainfall& rainfall, const Weighing& weighing);

  void add(std::span<const double> readings);
  /// By basin, in the readings' unit; NaN where it cannot be had. Does not depend on `threads`.
  std::vector<double> result(unsigned threads);
  /// Why the result has no figures at all; empty where it has.
  const std::string& shortfall() const { return shortfall_; }

 private:
  struct Pair {
    std::uint32_t a;
    std::uint32_t b;
    double sum = 0;  // of b's readings less a's, where both report
    double squares = 0;
    std::size_t steps = 0;
  };

  void add_pairs();
  /// The variance of the mean field, and how much of it comes and goes.
  struct Variance {
    FieldVariance whole;
    double passing;
  };
  /// By basin, the mean square for the weights of a step, in the mean, and for the mean weights.
  struct Squares {
    std::vector<double> mean;
    std::vector<double> of_mean;
  };

  Variance variance(const StepVariance& of_field) const;
  Squares squares(const RainfallError& error, unsigned threads) const;

  const ArealRainfall& rainfall_;
  const Weighing& weighing_;
  Sites sites_;
  std::vector<Pair> pairs_;
  std::size_t steps_ = 0;
  StepSample sample_;
  std::string shortfall_;
};

}  // namespace thiessen
