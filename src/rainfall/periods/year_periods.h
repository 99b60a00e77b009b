#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rainfall/periods/periods_of_days.h"

namespace thiessen {

/// Years that begin with any month, such as water years. A year has the name of that in which it
/// ends: from October 2013 to September 2014 it is 2014.
class YearPeriods : public PeriodsOfDays {
 public:
  /// `year_start`: the first month, from 1.
  YearPeriods(std::int64_t day_start, int year_start)
      : PeriodsOfDays(day_start), year_start_(year_start) {}

  std::string name_of(std::int64_t number, std::optional<int> ahead_of_utc) const override;

 protected:
  std::int64_t number_of_day(std::int64_t day) const override;
  std::int64_t first_day(std::int64_t number) const override;
  TimePrecision precision_of_day() const override {
    return year_start_ == 1 ? TimePrecision::year : TimePrecision::month;
  }

 private:
  /// The months by which a year begins before the January that gives it its name.
  std::int64_t months_before() const { return year_start_ == 1 ? 0 : 13 - year_start_; }

  int year_start_;
};

}  // namespace thiessen
