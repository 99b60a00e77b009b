#include "rainfall/errors/total_error.h"

#include <algorithm>
#include <cmath>

namespace thiessen {

void TotalError::add(const BasinRainfall& step, double factor,
                     const ErrorCorrelation& correlation) {
  const std::size_t lags = correlation.at_lags.size();
  last_.resize(lags + 1);
  const double error = std::isnan(step.rainfall) ? 0 : factor * step.error_of_step;
  std::size_t at = steps_ % last_.size();
  last_[at] = error;
  products_ += (1 - correlation.lasting) * error * error;
  for (std::size_t k = 1; k <= std::min(lags, steps_); ++k) {
    at = (at == 0 ? last_.size() : at) - 1;
    products_ += 2 * (correlation.at_lags[k - 1] - correlation.lasting) * error * last_[at];
  }
  sum_ += error;
  if (!std::isnan(step.rainfall)) of_normals_ += factor * step.error_of_normals;
  ++steps_;
}

double TotalError::standard_error(const ErrorCorrelation& correlation) const {
  const double square = products_ + correlation.lasting * sum_ * sum_;
  // Rounding may leave less than 0 where errors cancel; what is not known has to stay so.
  return std::hypot(std::sqrt(square < 0 ? 0 : square), of_normals_);
}

}  // namespace thiessen
