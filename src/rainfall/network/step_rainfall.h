#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "rainfall/network/weights.h"

namespace thiessen {

/// The areal rainfall of one basin at one time.
struct BasinRainfall {
  double rainfall;  ///< sum of weight x factor x reading, in the readings' unit; NaN where there is
                    ///< none
  std::size_t gauges;  ///< number of gauges that weigh in the value
  double coverage;     ///< share of the basin that the full network gives to gauges that report
  /// The standard error of the rainfall, if it was asked for (see RainfallError) and there is one;
  /// else NaN.
  double standard_error = std::numeric_limits<double>::quiet_NaN();
  /// What the squares of the standard error are made of: what belongs to the step, and what normals
  /// make, which is the same share of the rainfall at all steps. The first is 0 where all gauges
  /// read the same, though that is no standard error.
  double error_of_step = std::numeric_limits<double>::quiet_NaN();
  double error_of_normals = 0;
};

/// Turns the readings of a step into areal rainfall. Safe for several threads at once; the result
/// depends on the readings alone.
class StepRainfall {
 public:
  virtual ~StepRainfall() = default;
  /// The values of a step, one for each series: a series is a basin, or a basin and a method.
  /// `readings` has one entry for each station, NaN where it is silent.
  virtual std::vector<BasinRainfall> at(std::span<const double> readings) const = 0;
  /// The weights that the values of a step are made with, one set for each series; a series without
  /// a value has no weights. To rounding, the value is the sum of weight x factor x
  /// reading.
  virtual std::vector<BasinWeights> weights_at(std::span<const double> readings) const = 0;
  /// Whether calendar months have normals of their own. What this says itself is then by the
  /// year's.
  virtual bool tells_months() const { return false; }
  /// The rainfall of the steps of a calendar month, from 0; this where months are not told apart.
  virtual const StepRainfall& in_month(std::size_t /*month*/) const { return *this; }
};

}  // namespace thiessen
