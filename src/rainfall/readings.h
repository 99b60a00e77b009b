#pragma once

#include <span>
#include <string>

namespace thiessen {

/// What the gauges read at one time. A silent gauge's reading is NaN.
struct TimeStep {
  std::string time;  ///< as the file writes it
  std::span<const double>
      readings;  ///< one for each station, in the stations' order; valid until the next step
};

/// A table of readings, a time step after the other, in the order in which the times first came.
class Readings {
 public:
  virtual ~Readings() = default;
  /// Fills `step`; false at the end. Throws Error where the input is bad.
  virtual bool next(TimeStep& step) = 0;
};

}  // namespace thiessen
