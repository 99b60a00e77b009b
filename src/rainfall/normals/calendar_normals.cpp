#include "rainfall/normals/calendar_normals.h"

#include <algorithm>
#include <cmath>

namespace thiessen {

CalendarNormals::CalendarNormals(std::size_t places)
    : places_(places),
      year_(places),
      by_month_(months, SeriesNormals(places)),
      reporting_(months) {}

void CalendarNormals::add(std::span<const double> readings,
                          const std::optional<MonthOfYear>& when) {
  year_.add(readings);
  if (!when) tells_months_ = false;
  if (!tells_months_) return;
  by_month_[when->month].add(readings);
  std::vector<bool>& reporting = reporting_[when->month][when->year];
  reporting.resize(places_);
  for (std::size_t place = 0; place < places_; ++place) {
    if (!std::isnan(readings[place])) reporting[place] = true;
  }
}

std::size_t CalendarNormals::places_with_enough_years() const {
  if (!tells_months_) return 0;
  std::size_t enough = 0;
  for (std::size_t place = 0; place < places_; ++place) {
    enough += std::all_of(reporting_.begin(), reporting_.end(), [&](const auto& by_year) {
      return static_cast<std::size_t>(std::count_if(
                 by_year.begin(), by_year.end(),
                 [&](const auto& of_year) { return of_year.second[place]; })) >= least_years;
    });
  }
  return enough;
}

}  // namespace thiessen
