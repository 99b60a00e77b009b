#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/iso_time.h"
#include "geometry/long_sum.h"
#include "rainfall/network/network.h"
#include "rainfall/network/reporting.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/step_intervals.h"
#include "rainfall/series/step_length.h"

namespace thiessen {

/// One value for each gauge: at one time, or the mean over the times at which it reports. Gauges at
/// one place have one value, that of the place: at a time the mean of those of its gauges that
/// report then; over several times the mean of the place's own values. So a place counts the same
/// in cells, pictures, rasters and areal rainfall.
struct GaugeReadings {
  std::vector<double> readings;  ///< by station; NaN where there is none
  std::string label;             ///< what the values are: the time, or which means
  std::optional<StepLength> step =
      {};                 ///< how long a value's rain fell; nothing where that is not known
  std::string unit = {};  ///< what the values are in; empty where that is not known
  /// The calendar month of a time, from 0; nothing for means, and where the time tells none.
  std::optional<std::size_t> month = {};

  ReportingStations reports() const { return reporting_stations(readings); }
};

/// Gathers the mean value at each place of a network, one step after the other. Cost of a step: its
/// gauges.
class MeanReadings {
 public:
  /// The network must outlive this object.
  explicit MeanReadings(const Network& network);

  void add(std::span<const double> readings);
  /// Takes note of what a step is called and of its time, so that the means know the length of a
  /// step, and what to call the only one.
  void note(const std::string& name, const ParsedTime& time);
  /// The length of a step, by the times that were noted: see StepIntervals.
  std::optional<StepLength> step() const;
  /// The means of the gauges that have a reading in some step; the others have none.
  GaugeReadings of_reporting() const;
  /// The means of all gauges of the network: one without a reading in any step has that of its
  /// place, if there is one.
  GaugeReadings of_all() const;

 private:
  double mean_at(PlaceIndex place) const;
  std::string label() const;

  const Network& network_;
  std::vector<LongSum> sum_;  // by place, so that the order of the steps does not matter
  std::vector<std::size_t> count_;
  ReportingStations heard_;
  StepIntervals intervals_;
  std::string name_;  ///< of the step that was noted last
  std::size_t steps_ = 0;
};

/// Reads the whole table and gives the steps at these times, in their order. A time that the table
/// lacks has no label and no readings. Memory: the readings of these steps.
std::vector<GaugeReadings> read_steps(Readings& readings, const Network& network,
                                      std::span<const std::string> times);

/// Reads the whole table and gives the step at `time`, or the means of the gauges that report where
/// `time` is empty. If the table lacks that time there is no label and no readings.
GaugeReadings read_gauges(Readings& readings, const Network& network, const std::string& time);

}  // namespace thiessen
