#pragma once

#include <atomic>
#include <cstddef>

namespace thiessen::python {

/// How far a long call has come: written by the threads that work, read by the one that waits.
class Progress {
 public:
  void begin(std::size_t total) { total_.store(total, std::memory_order_relaxed); }
  void advance(std::size_t steps) { done_.fetch_add(steps, std::memory_order_relaxed); }
  std::size_t done() const { return done_.load(std::memory_order_relaxed); }
  /// How many steps there are; 0 where that is not known before the file has been read.
  std::size_t total() const { return total_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::size_t> done_ = 0;
  std::atomic<std::size_t> total_ = 0;
};

}  // namespace thiessen::python
