#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace thiessen {

/// Where the readings of a gauge stand on a line of equal steps, such as seconds or months, and how
/// far they are apart.
class SpacedReadings {
 public:
  /// Takes note of a reading, in whatever order they come. It stands here, as it is called for each
  /// reading of a file.
  void note(std::int64_t at) {
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

  std::uint32_t count() const { return count_; }
  /// Where the last reading is that was noted. Requires a reading.
  std::int64_t last() const { return last_; }
  /// The greatest common divisor of the intervals between them; 0 where all are at one place.
  std::int64_t apart() const { return apart_; }
  /// Whether they are many enough to tell of steps of their own, and are in more than half of the
  /// steps of the length `apart()` between the first and the last. Requires that to be more than 0.
  bool fill_their_steps() const;

 private:
  static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::min();

  std::int64_t last_ = never;
  std::int64_t low_ = never;
  std::int64_t high_ = never;
  std::int64_t apart_ = 0;
  std::uint32_t count_ = 0;
};

}  // namespace thiessen
