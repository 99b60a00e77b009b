#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "rainfall/weights.h"

namespace thiessen {

/// The areal rainfall of one basin at one time.
struct BasinRainfall {
  double rainfall;  ///< sum of weight x reading, in the readings' unit; NaN where it cannot be had
  std::size_t gauges;  ///< that weigh in the value
  double coverage;     ///< share of the basin that the full network gives to gauges that report
  /// Of the rainfall, where it was asked for (see RainfallError) and can be had; else NaN.
  double standard_error = std::numeric_limits<double>::quiet_NaN();
};

/// Turns readings into areal rainfall. Safe for several threads at once; what it gives depends on
/// the readings alone.
class StepRainfall {
 public:
  virtual ~StepRainfall() = default;
  /// By series: a basin, or a basin and a method. `readings`: one a station, NaN where it is
  /// silent.
  virtual std::vector<BasinRainfall> at(std::span<const double> readings) const = 0;
  /// By series, with what weights: one without a value has none. The sum of weight x reading is the
  /// value, to rounding.
  virtual std::vector<BasinWeights> weights_at(std::span<const double> readings) const = 0;
};

}  // namespace thiessen
