#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/iso_time.h"

namespace thiessen {

/// What tells the steps of a series from each other: the moment where the time is of ISO 8601,
/// however it is written, else its text.
struct StepKey {
  bool is_moment = false;
  bool has_zone = false;
  TimePrecision precision = TimePrecision::year;
  std::int64_t seconds = 0;  ///< by moment_seconds
  int nanosecond = 0;
  std::string text;  ///< only of a time that is no moment

  friend bool operator==(const StepKey&, const StepKey&) = default;
};

StepKey step_key(std::string_view time);

/// Whether times of these keys may stand in one series: both moments, of one precision, with a zone
/// or without, or neither.
bool are_alike(const StepKey& a, const StepKey& b);
/// Whether a moment comes before another. False where one of them is none.
bool comes_before(const StepKey& a, const StepKey& b);
std::uint64_t hash_of(const StepKey& key);

}  // namespace thiessen
