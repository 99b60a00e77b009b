#pragma once

#include <cstddef>
#include <ctime>

namespace thiessen {

/// Seconds of processor time that this thread has used so far. Cost: half a microsecond.
inline double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Says which steps of a series are timed: the first ones all, as they may cost more, and of a long
/// series one in so many, for steps of few gauges take less time than the clock does.
class TimedSteps {
 public:
  static constexpr std::size_t all_of_first = 250;
  /// A prime, so that no season or week is met at the same phase each time.
  static constexpr std::size_t one_in = 17;

  /// Takes the next step: for how many steps its time stands, 0 where it is not timed.
  std::size_t next() {
    const std::size_t number = seen_++;
    if (number < all_of_first) return 1;
    return (number - all_of_first) % one_in == one_in / 2 ? one_in : 0;
  }

 private:
  std::size_t seen_ = 0;
};

}  // namespace thiessen
