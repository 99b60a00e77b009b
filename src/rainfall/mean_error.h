#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rainfall/areal_rainfall.h"
#include "rainfall/sites.h"
#include "rainfall/step_sample.h"
#include "rainfall/step_variance.h"
#include "rainfall/weights.h"

namespace thiessen {

/// The standard error of the mean rainfall over a series, by basin, in one pass.
///
/// As RainfallError has it of one step, but with the variance that near gauges' mean differences
/// tell, over the steps that both report: so what cancels from step to step cancels here, and what
/// lasts does not. Two gauges count where they report together at half as many steps or more as the
/// two that do so most often; what their mean difference would have lost over all steps, were it
/// for the scatter of single ones, is taken off its square. The mean square for the weights is that
/// of a sample of the steps, in the mean. With errors independent from step to step it is what
/// adding up their squares gives.
///
/// Cost of a step: six differences a gauge. In the end: RainfallError's, and a hundred of its
/// steps. Memory: 100 bytes a gauge, and the sample.
class MeanError {
 public:
  /// The rainfall and the weighing must outlive it.
  MeanError(const ArealRainfall& rainfall, const Weighing& weighing);

  void add(std::span<const double> readings);
  /// By basin, in the readings' unit; NaN where it cannot be had. Does not depend on `threads`.
  std::vector<double> result(unsigned threads) const;

 private:
  struct Pair {
    std::uint32_t a;
    std::uint32_t b;
    double sum = 0;  // of b's readings less a's, where both report
    double squares = 0;
    std::size_t steps = 0;
  };

  void add_pairs();
  FieldVariance variance(const StepVariance& of_field) const;

  const ArealRainfall& rainfall_;
  const Weighing& weighing_;
  Sites sites_;
  std::vector<Pair> pairs_;
  std::size_t steps_ = 0;
  StepSample sample_;
};

}  // namespace thiessen
