#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/sites.h"
#include "rainfall/errors/step_variance.h"
#include "rainfall/network/step_rainfall.h"
#include "rainfall/network/weights.h"
#include "rainfall/series/step_sample.h"

namespace thiessen {

class RainfallError;

/// The standard error of each basin's mean rainfall over a whole series, gathered in one pass.
///
/// The model is RainfallError's, but the field is here the mean over all steps. Its variance is
/// estimated from the mean differences of near gauges, taken over the steps at which both report.
/// So errors that cancel from step to step cancel in the result, and errors that last (a hill that
/// is always wetter) stay in it. A pair of gauges counts if both report at no fewer than half
/// as many steps as the pair that reports together most often.
///
/// The variance has two parts. The passing part is what the scatter of single steps explains, if
/// the steps are independent of each other. It is multiplied by the mean square of the error for
/// the weights of a step (see RainfallError::mean_squares), averaged over a sample of the steps.
/// The lasting part is the rest. It is multiplied by the mean square for the mean of these steps'
/// weights: where one gauge is silent now and another then, a gauge's lasting error cancels in
/// part.
///
/// With normals the field is that of readings divided by normals (FieldParts), whose errors count
/// times the basin's mean normal; and the error of that normal, which lasts as a share of each
/// value, is added. Where normals are fitted to the same series all gauges' means of that field are
/// the same, and the error of the normals is all there is. In months that have normals of their own
/// the readings are divided by those; the weights are by the year's.
///
/// Cost of a step: six differences a gauge. Cost of the result: that of a RainfallError and of a
/// hundred of its steps. Memory: 100 bytes a gauge, and the sample.
class MeanError {
 public:
  /// The rainfall is by the year's normals; it and the weighing must outlive this object.
  MeanError(const ArealRainfall& rainfall, const Weighing& weighing);

  /// Takes the next step: its readings, one for each station, NaN where it is silent; its values by
  /// basin; and its month, where months have normals of their own.
  void add(std::span<const double> readings, std::span<const BasinRainfall> values,
           const NormalMonth& month);
  /// The same without normals, where the values do not matter.
  void add(std::span<const double> readings) { add(readings, {}, {}); }
  /// The standard errors by basin, in the readings' unit; NaN where there is none. They do not
  /// depend on `threads`.
  std::vector<double> result(unsigned threads);
  /// Says why the result has no figures at all; empty where it has some.
  const std::string& shortfall() const { return shortfall_; }

 private:
  struct Pair {
    std::uint32_t a;
    std::uint32_t b;
    double sum = 0;         // of the differences b - a, over the steps at which both report
    double squares = 0;     // of the same differences
    std::size_t steps = 0;  // at which both report
  };

  /// The errors of normals, which are a share of each value, and how many values there are.
  struct OfNormals {
    double sum = 0;
    std::size_t values = 0;
  };

  void add_pairs();
  void add_normals(std::span<const BasinRainfall> values, const NormalMonth& month);
  /// The variance of the mean field, and the passing part of it.
  struct Variance {
    FieldVariance whole;
    double passing;
  };
  /// Mean squares of the error by basin, in units of the field's variance: the average of those for
  /// the weights of single steps, and the one for the mean of these weights.
  struct Squares {
    std::vector<double> mean;
    std::vector<double> of_mean;
  };

  Variance variance(const StepVariance& of_field) const;
  double error_of_normal(std::size_t basin) const;
  Squares squares(const RainfallError& error, unsigned threads) const;

  const ArealRainfall& rainfall_;
  const Weighing& weighing_;
  Sites sites_;
  std::vector<Pair> pairs_;
  std::size_t steps_ = 0;
  StepSample sample_;
  std::vector<OfNormals> of_normals_;  // by basin
  std::string shortfall_;
};

}  // namespace thiessen
