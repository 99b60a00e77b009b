#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace thiessen::cli {

/// Counts a long step's units on the terminal, and says how much is done and how long the rest will
/// take: a line that is written over. Silent in a pipe, and for the first second.
class Progress {
 public:
  /// How much is done, from 0 to 1; NaN where nobody knows.
  using Share = std::function<double(std::size_t done)>;

  /// `unit`: what is counted, one of them.
  Progress(std::string unit, bool quiet, Share share);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(std::size_t count = 1);

 private:
  std::string line() const;

  std::string unit_;
  Share share_;
  bool shows_;
  bool shown_ = false;
  std::size_t done_ = 0;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace thiessen::cli
