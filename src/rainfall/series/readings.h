#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

namespace thiessen {

/// What the gauges read at one time. A silent gauge's reading is NaN.
struct TimeStep {
  std::string time;  ///< as the file writes it
  std::span<const double>
      readings;  ///< one for each station, in the stations' order; valid until the next step
  std::size_t line = 0;  ///< where the time first came; 0 where that is not known
};

/// A table of readings, a time step after the other, in the order in which the times first came.
class Readings {
 public:
  virtual ~Readings() = default;
  /// Fills `step`; false at the end. Throws Error where the input is bad.
  virtual bool next(TimeStep& step) = 0;
  /// How much of the input is read, from 0 to 1; NaN where its length is not known. For the thread
  /// that reads: another asks WatchedReadings.
  virtual double share_read() const { return std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace thiessen
