#pragma once

#include <cstdint>
#include <optional>

#include "rainfall/series/step_length.h"

namespace thiessen {

/// What a reading of 1 stands for: so many millimetres, in its step or, of a rate, in a time.
struct AmountMeaning {
  double millimetres = 1;
  std::optional<StepLength> rate = {};

  /// The reading that stands for 1 mm in a step of so many seconds.
  double of_millimetre(std::int64_t step_seconds) const {
    if (!rate || rate->seconds == 0) return 1 / millimetres;
    return static_cast<double>(rate->seconds) / static_cast<double>(step_seconds) / millimetres;
  }
};

}  // namespace thiessen
