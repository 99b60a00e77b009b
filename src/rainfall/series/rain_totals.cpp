#include "rainfall/series/rain_totals.h"

#include <cstdint>
#include <stdexcept>
#include <utility>

#include "rainfall/series/rain_periods.h"
#include "rainfall/series/rain_storms.h"

namespace thiessen {

std::optional<StepLength> length_of(const Every& every) {
  switch (every.unit) {
    case PeriodUnit::hours:
      return StepLength{0, std::int64_t{3'600} * every.hours};
    case PeriodUnit::day:
      return StepLength{0, seconds_of_day};
    case PeriodUnit::week:
      return StepLength{0, 7 * seconds_of_day};
    case PeriodUnit::month:
      return StepLength{1, 0};
    case PeriodUnit::season:
      return StepLength{3, 0};
    case PeriodUnit::year:
      return StepLength{12, 0};
    case PeriodUnit::storm:
      return std::nullopt;
  }
  throw std::logic_error("not a period");
}

std::unique_ptr<RainTotals> totals_of(Totalling totalling, std::string file,
                                      RainTotals::Take take) {
  if (totalling.every.unit == PeriodUnit::storm) {
    return std::make_unique<RainStorms>(std::move(totalling), std::move(file), std::move(take));
  }
  return std::make_unique<RainPeriods>(std::move(totalling), std::move(file), std::move(take));
}

}  // namespace thiessen
