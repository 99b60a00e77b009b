#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace thiessen::cli {

/// Counts a long step's units on the terminal, a line that is written over; silent in a pipe, and
/// for the first second.
class Progress {
 public:
  Progress(std::string what, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(std::size_t count = 1);

 private:
  std::string what_;
  bool shows_;
  bool shown_ = false;
  std::size_t done_ = 0;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace thiessen::cli
