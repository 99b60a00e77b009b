#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace thiessen::cli {

/// Counts the units of a long task on the terminal, and says which share is done and how long the
/// rest will take, in a line that is written over. Silent in a pipe, and for the first second.
class Progress {
 public:
  /// Returns the share of the work that is done, from 0 to 1, or NaN where it is not known.
  using Share = std::function<double(std::size_t done)>;

  /// `unit` names one of the things counted.
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
