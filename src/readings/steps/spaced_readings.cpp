#include "readings/steps/spaced_readings.h"

namespace thiessen {

bool SpacedReadings::fill_their_steps() const {
  constexpr std::uint32_t readings_that_tell = 3;
  return count_ >= readings_that_tell && (high_ - low_) / apart_ + 1 < 2 * std::int64_t{count_};
}

}  // namespace thiessen
