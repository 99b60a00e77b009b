#include "rainfall/periods/period_calendar.h"

#include <stdexcept>

#include "rainfall/periods/day_periods.h"
#include "rainfall/periods/hour_periods.h"
#include "rainfall/periods/month_periods.h"
#include "rainfall/periods/season_periods.h"
#include "rainfall/periods/week_periods.h"
#include "rainfall/periods/year_periods.h"

namespace thiessen {

std::unique_ptr<const PeriodCalendar> calendar_of(const Every& every) {
  switch (every.unit) {
    case PeriodUnit::hours:
      return std::make_unique<const HourPeriods>(every.hours, every.day_start, every.first_day);
    case PeriodUnit::day:
      return std::make_unique<const DayPeriods>(every.day_start);
    case PeriodUnit::week:
      return std::make_unique<const WeekPeriods>(every.day_start);
    case PeriodUnit::month:
      return std::make_unique<const MonthPeriods>(every.day_start);
    case PeriodUnit::season:
      return std::make_unique<const SeasonPeriods>(every.day_start);
    case PeriodUnit::year:
      return std::make_unique<const YearPeriods>(every.day_start, every.year_start);
    case PeriodUnit::storm:
      break;
  }
  throw std::logic_error("no calendar has storms");
}

}  // namespace thiessen
