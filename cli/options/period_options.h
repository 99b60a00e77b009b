#pragma once

#include <cstddef>
#include <optional>

#include "base/iso_time.h"
#include "cli/options/option_list.h"
#include "rainfall/series/dated_readings.h"
#include "rainfall/series/rain_periods.h"

namespace thiessen::cli {

/// Which steps count, and what they are summed over.
class PeriodOptions : public OptionBlock {
 public:
  void declare(OptionList& options);
  /// Only which steps count.
  void declare_range(OptionList& options);
  /// Throws UsageError for options that contradict each other.
  void check() const;
  /// What is asked of the times, if anything.
  std::optional<StepTimes> times() const;
  /// None: the steps themselves are wanted.
  std::optional<Totalling> totalling() const;

 private:
  TimeRange range_;
  std::optional<TimePrecision> every_;
  std::size_t allowed_missing_ = 0;
  const Option* from_option_ = nullptr;
  const Option* to_option_ = nullptr;
  const Option* allowed_missing_option_ = nullptr;
};

}  // namespace thiessen::cli
