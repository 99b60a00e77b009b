#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

namespace thiessen {

/// What the gauges read at one time; NaN where a gauge is silent.
struct TimeStep {
  std::string time;  ///< as the file writes it
  std::span<const double>
      readings;  ///< one for each station, in the stations' order; valid until the next step
  std::size_t line = 0;  ///< where the time first came; 0 where that is not known
};

/// A table of readings, read one time step after the other in the order in which the times first
/// came.
class Readings {
 public:
  virtual ~Readings() = default;
  /// Reads the next step into `step`; returns false at the end. Throws Error where the input is
  /// bad.
  virtual bool next(TimeStep& step) = 0;
  /// What the readings are in, such as mm; empty where that is not known.
  virtual std::string unit() const { return {}; }
  /// The share of the input that has been read, from 0 to 1; NaN where its length is not known.
  /// Only the thread that reads may ask; other threads ask WatchedReadings.
  virtual double share_read() const { return std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace thiessen
