#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/option_list.h"
#include "cli/options/period_values.h"
#include "rainfall/periods/every.h"
#include "rainfall/series/dated_readings.h"
#include "rainfall/series/rain_totals.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/time_range.h"

namespace thiessen::cli {

/// The options that say which steps count, and over which periods they are summed.
class PeriodOptions : public OptionBlock {
 public:
  void declare(OptionList& options);
  /// Declares only the options that say which steps count.
  void declare_range(OptionList& options);
  /// Declares the option that says what times are of their steps.
  void declare_stamp(OptionList& options, const std::string& decides);
  /// Declares the option that asks for the largest depths in lengths of time.
  void declare_depths(OptionList& options);
  const std::vector<NamedDuration>& depths() const { return depths_; }
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
  /// Whether the totals are of storms, each of which has its own length.
  bool are_storms() const { return every_ && every_->unit == PeriodUnit::storm; }
  /// What is required of the times of steps: their range, and how precise totals need them; none
  /// where nothing is required.
  std::optional<StepTimes> times() const;
  /// The periods over which steps are summed; none where the steps themselves are wanted.
  std::optional<Totalling> totalling() const;

 private:
  void declare_periods(OptionGroup& output);
  void check_periods() const;
  std::optional<Every> every() const;

  TimeRange range_;
  std::optional<Every> every_;
  std::int64_t day_start_ = 0;
  std::size_t year_start_ = 1;
  std::int64_t dry_ = 21'600;
  std::vector<NamedDuration> depths_;
  std::size_t allowed_missing_ = 0;
  Stamp stamp_ = Stamp::begin;
  const Option* stamp_option_ = nullptr;
  const Option* every_option_ = nullptr;
  const Option* from_option_ = nullptr;
  const Option* to_option_ = nullptr;
  const Option* allowed_missing_option_ = nullptr;
  const Option* day_start_option_ = nullptr;
  const Option* year_start_option_ = nullptr;
  const Option* dry_option_ = nullptr;
};

}  // namespace thiessen::cli
