#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "base/iso_time.h"

namespace thiessen {

/// The step that a series of times keeps to, as far as its times have come: the interval that at
/// least half of them are apart, by the calendar (months, years) where that holds, else by the
/// clock; of two that are equally frequent the shorter one. A series whose intervals are more
/// various has none. Memory: some 60 bytes for each different interval, up to 1,000 of them.
class UsualStep {
 public:
  /// Takes note of the next time, in the order of time.
  void note(const IsoTime& time);
  /// Whether a time follows another by two steps or more. False where there is no usual step.
  bool lacks_between(const IsoTime& before, const IsoTime& after) const;

 private:
  /// Intervals of one kind by their length, and the most frequent of them.
  struct Intervals {
    std::map<std::int64_t, std::size_t> counts;
    std::int64_t usual = 0;
    std::size_t times_usual = 0;

    void note(std::int64_t length);
  };

  std::optional<IsoTime> last_;
  std::size_t intervals_ = 0;
  Intervals seconds_;
  Intervals months_;
};

}  // namespace thiessen
