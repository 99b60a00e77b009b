#include "rainfall/errors/errors_of_series.h"

#include <utility>
#include <vector>

#include "rainfall/network/mean_reading.h"
#include "rainfall/normals/relative_readings.h"

namespace thiessen {

ErrorsOfSeries::ErrorsOfSeries(const Weighing& weighing, Of of)
    : weighing_(weighing),
      sample_(weighing.network().stations().size(),
              steps_for_errors(weighing.network().stations().size())) {
  if (of == Of::totals) differences_.emplace(weighing.network(), weighing.yardstick().metric);
}

void ErrorsOfSeries::add(std::span<const double> readings, const NormalMonth& month) {
  const std::vector<double> of_field = relative_readings(weighing_.normals(), readings, month);
  sample_.add(of_field);
  if (differences_) differences_->add(readings_by_place(weighing_.network(), of_field));
}

std::shared_ptr<const ErrorCorrelation> ErrorsOfSeries::correlation() const {
  if (!differences_) return nullptr;
  return std::make_shared<const ErrorCorrelation>(differences_->result());
}

std::unique_ptr<const RainfallError> ErrorsOfSeries::of(
    std::unique_ptr<const WeighedRainfall> rainfall, const NormalMonth& month, unsigned threads) {
  if (first_.model)
    return std::make_unique<const RainfallError>(first_, std::move(rainfall), month, threads);
  auto error = std::make_unique<const RainfallError>(std::move(rainfall), month, weighing_, sample_,
                                                     threads);
  first_ = error->fitted();
  return error;
}

}  // namespace thiessen
