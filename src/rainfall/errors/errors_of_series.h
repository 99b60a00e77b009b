#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "rainfall/errors/error_correlation.h"
#include "rainfall/errors/rainfall_error.h"

namespace thiessen {

/// Fits the one model of standard errors to a series that passes once, and then gives the rainfall
/// its errors: that of each method, and of each calendar month where months have normals of their
/// own.
class ErrorsOfSeries {
 public:
  /// What the errors are wanted of: those of totals take how they go together in time.
  enum class Of { steps, totals };

  /// The weighing must outlive this object and what it makes.
  explicit ErrorsOfSeries(const Weighing& weighing, Of of = Of::steps);

  /// Takes the next step. `month` is to be given where months have normals of their own.
  void add(std::span<const double> readings, const NormalMonth& month);
  /// The rainfall by one method, for a month or by the year's normals, with errors.
  std::unique_ptr<const RainfallError> of(std::unique_ptr<const WeighedRainfall> rainfall,
                                          const NormalMonth& month, unsigned threads);
  /// How the errors of steps go together, where those of totals are wanted.
  std::shared_ptr<const ErrorCorrelation> correlation() const;

 private:
  const Weighing& weighing_;
  StepSample sample_;
  std::optional<DifferencesInTime> differences_;
  FittedErrors first_;  // nothing until some rainfall is given its errors
};

}  // namespace thiessen
