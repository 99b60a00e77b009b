#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "rainfall/errors/error_correlation.h"
#include "rainfall/network/step_rainfall.h"

namespace thiessen {

/// The standard error of one basin's total over a period, summed up while its steps pass.
///
/// Its square is the double sum over the period's steps of the correlation at their lag times both
/// steps' errors, and the square of the sum of what normals err, which is the same share of all.
/// Cost of a step: the lags whose correlation is known. Memory: as many numbers.
class TotalError {
 public:
  /// Adds the period's next step, whose value counts times `factor`. Without a value it adds
  /// nothing but keeps its place, for lags are counted in steps.
  void add(const BasinRainfall& step, double factor, const ErrorCorrelation& correlation);
  /// NaN where some step has a value but no error.
  double standard_error(const ErrorCorrelation& correlation) const;

 private:
  std::vector<double> last_;  // errors of the last steps, in turn
  std::size_t steps_ = 0;
  double products_ = 0;  // of errors, times what their correlation is above the lasting one
  double sum_ = 0;       // of errors
  double of_normals_ = 0;
};

/// The standard errors of the totals of all basins over one period after the other: none without a
/// correlation of errors.
class TotalErrors {
 public:
  explicit TotalErrors(std::shared_ptr<const ErrorCorrelation> correlation)
      : correlation_(std::move(correlation)) {}

  /// Begins a period.
  void begin(std::size_t basins) {
    if (correlation_) errors_.assign(basins, TotalError());
  }
  /// Adds a step of it, whose values count times `factor`.
  void add(std::span<const BasinRainfall> basins, double factor) {
    for (std::size_t b = 0; b < errors_.size(); ++b)
      errors_[b].add(basins[b], factor, *correlation_);
  }
  /// The standard error of a basin's total so far; NaN where there is none.
  double of(std::size_t basin) const {
    if (!correlation_) return std::numeric_limits<double>::quiet_NaN();
    return errors_[basin].standard_error(*correlation_);
  }

 private:
  std::shared_ptr<const ErrorCorrelation> correlation_;
  std::vector<TotalError> errors_;
};

}  // namespace thiessen
