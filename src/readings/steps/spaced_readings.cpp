#include "readings/steps/spaced_readings.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace thiessen {

void SpacedReadings::note(std::int64_t at) {
  if (count_ == 0) {
    low_ = high_ = at;
  } else {
    const std::int64_t apart = std::abs(at - last_);
    if (apart != apart_) apart_ = std::gcd(apart_, apart);
    low_ = std::min(low_, at);
    high_ = std::max(high_, at);
  }
  last_ = at;
  ++count_;
}

bool SpacedReadings::fill_their_steps() const {
  constexpr std::uint32_t readings_that_tell = 3;
  return count_ >= readings_that_tell && (high_ - low_) / apart_ + 1 < 2 * std::int64_t{count_};
}

}  // namespace thiessen
