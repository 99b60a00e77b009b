#include "rainfall/areal_rainfall.h"

#include <utility>

namespace thiessen {

ArealRainfall::ArealRainfall(const Weighing& weighing, const ArealRainfallSettings& settings,
                             unsigned threads)
    : ArealRainfall(
          std::make_shared<const CellWeigher>(
              weighing, CellWeigher::Keeping{settings.remembered_bytes, settings.counts_gauges()},
              threads),
          settings, NormalMonth()) {}

ArealRainfall::ArealRainfall(std::shared_ptr<const CellWeigher> cells,
                             const ArealRainfallSettings& settings, const NormalMonth& month)
    : WeighedRainfall(cells, settings, month), cells_(std::move(cells)) {}

}  // namespace thiessen
