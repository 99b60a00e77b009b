#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geometry/long_sum.h"
#include "rainfall/network/reporting.h"
#include "rainfall/series/readings.h"

namespace thiessen {

/// One reading for each gauge: at one time, or the mean over the times at which the gauge reports.
struct GaugeReadings {
  std::vector<double> readings;  ///< by station; NaN where it has none
  std::string label;             ///< the time, or "mean of 120 time steps"

  ReportingStations reports() const { return reporting_stations(readings); }
};

/// Gathers each gauge's mean reading, one step after the other. Cost of a step: its gauges.
class MeanReadings {
 public:
  explicit MeanReadings(std::size_t stations) : sum_(stations), count_(stations, 0) {}

  void add(std::span<const double> readings);
  GaugeReadings result() const;

 private:
  std::vector<LongSum> sum_;  // so that the order of the steps does not matter
  std::vector<std::size_t> count_;
  std::size_t steps_ = 0;
};

/// Reads the whole table and gives the step at `time`, or the means where `time` is empty. If the
/// table lacks that time there is no label and no readings.
GaugeReadings read_gauges(Readings& readings, std::size_t stations, const std::string& time);

}  // namespace thiessen
