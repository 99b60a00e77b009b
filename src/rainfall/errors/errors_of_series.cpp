#include "rainfall/errors/errors_of_series.h"

#include <utility>

#include "rainfall/normals/relative_readings.h"

namespace thiessen {

ErrorsOfSeries::ErrorsOfSeries(const Weighing& weighing)
    : weighing_(weighing),
      sample_(weighing.network().stations().size(),
              steps_for_errors(weighing.network().stations().size())) {}

void ErrorsOfSeries::add(std::span<const double> readings, const NormalMonth& month) {
  if (weighing_.normals() == nullptr) return sample_.add(readings);
  sample_.add(relative_readings(weighing_.normals(), readings, month));
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
