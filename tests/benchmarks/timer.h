#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <ctime>

namespace thiessen::benchmarks {

/// The processor's time for this program, so that others on the machine do not count.
class Timer {
 public:
  void start() { start_ = now(); }
  void stop() { seconds_ += now() - start_; }
  double seconds() const { return seconds_; }

 private:
  static double now() {
    std::timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double start_ = 0;
  double seconds_ = 0;
};

/// Of a benchmark with a time of its own.
inline void count_operations(benchmark::State& state, std::size_t operations, const Timer& timer) {
  state.SetIterationTime(timer.seconds());
  state.counters["an operation"] = benchmark::Counter(
      static_cast<double>(operations),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace thiessen::benchmarks
