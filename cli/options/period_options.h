#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/iso_time.h"
#include "cli/options/option_list.h"
#include "rainfall/series/dated_readings.h"
#include "rainfall/series/rain_periods.h"
#include "rainfall/series/stamp.h"

namespace thiessen::cli {

/// The options that say which steps count, and over which periods they are summed.
class PeriodOptions : public OptionBlock {
 public:
  void declare(OptionList& options);
  /// Declares only the options that say which steps count.
  void declare_range(OptionList& options);
  /// Declares the option that says what times are of their steps.
  void declare_stamp(OptionList& options);
  Stamp stamp() const { return stamp_; }
  /// Takes what RAINFALL itself says of its times, where it does. Throws Error where the option
  /// says otherwise.
  void settle_stamp(std::optional<Stamp> known, const std::string& rainfall);
  /// The option that says so; nullptr where it is not given.
  const Option* stamp_option() const {
    return stamp_option_ != nullptr && stamp_option_->is_given() ? stamp_option_ : nullptr;
  }
  /// Throws UsageError for options that contradict each other. `has_bounds`: what is written says
  /// when its steps begin and end.
  void check(bool has_bounds = false) const;
  /// What is required of the times of steps: their range, and how precise totals need them; none
  /// where nothing is required.
  std::optional<StepTimes> times() const;
  /// The periods over which steps are summed; none where the steps themselves are wanted.
  std::optional<Totalling> totalling() const;

 private:
  TimeRange range_;
  std::optional<TimePrecision> every_;
  std::size_t allowed_missing_ = 0;
  Stamp stamp_ = Stamp::begin;
  const Option* stamp_option_ = nullptr;
  const Option* every_option_ = nullptr;
  const Option* from_option_ = nullptr;
  const Option* to_option_ = nullptr;
  const Option* allowed_missing_option_ = nullptr;
};

}  // namespace thiessen::cli
