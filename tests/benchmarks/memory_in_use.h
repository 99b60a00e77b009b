#pragma once

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <cstddef>

namespace thiessen::benchmarks {

/// Bytes that are allocated now, the allocator's own among them.
inline std::size_t memory_in_use() {
  const auto use = mallinfo2();
  return use.uordblks + use.hblkhd;
}

/// Reports time and, where it is known, memory a point.
inline void count_points(benchmark::State& state, std::size_t points, std::size_t bytes) {
  const auto count = static_cast<double>(points);
  state.counters["a point"] = benchmark::Counter(
      count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  if (bytes > 0) state.counters["bytes a point"] = static_cast<double>(bytes) / count;
}

}  // namespace thiessen::benchmarks
