#include "rainfall/periods/every.h"

#include <stdexcept>

namespace thiessen {

TimePrecision Every::least_precision() const {
  if (unit == PeriodUnit::hours) return TimePrecision::instant;
  if (unit == PeriodUnit::storm) return TimePrecision::day;
  if (day_start != 0) return TimePrecision::instant;
  switch (unit) {
    case PeriodUnit::day:
    case PeriodUnit::week:
      return TimePrecision::day;
    case PeriodUnit::month:
    case PeriodUnit::season:
      return TimePrecision::month;
    case PeriodUnit::year:
      return year_start == 1 ? TimePrecision::year : TimePrecision::month;
    case PeriodUnit::hours:
    case PeriodUnit::storm:
      break;
  }
  throw std::logic_error("not a period");
}

}  // namespace thiessen
