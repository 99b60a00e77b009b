#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rainfall/periods/periods_of_days.h"

namespace thiessen {

/// The seasons of three months: 2014-DJF begins in December 2013, for a season has the year of its
/// January; MAM, JJA and SON follow.
class SeasonPeriods : public PeriodsOfDays {
 public:
  using PeriodsOfDays::PeriodsOfDays;

  std::string name_of(std::int64_t number, std::optional<int> ahead_of_utc) const override;

 protected:
  std::int64_t number_of_day(std::int64_t day) const override;
  std::int64_t first_day(std::int64_t number) const override;
  TimePrecision precision_of_day() const override { return TimePrecision::month; }
};

}  // namespace thiessen
