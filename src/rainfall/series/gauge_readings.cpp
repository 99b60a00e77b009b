#include "rainfall/series/gauge_readings.h"

#include <cmath>
#include <limits>

#include "base/interrupt.h"

namespace thiessen {

void MeanReadings::add(std::span<const double> readings) {
  ++steps_;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (std::isnan(readings[i])) continue;
    sum_[i].add(readings[i]);
    ++count_[i];
  }
}

GaugeReadings MeanReadings::result() const {
  GaugeReadings result;
  result.label = "mean of " + std::to_string(steps_) + (steps_ == 1 ? " time step" : " time steps");
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    result.readings.push_back(count_[i] == 0 ? std::numeric_limits<double>::quiet_NaN()
                                             : sum_[i].value() / static_cast<double>(count_[i]));
  }
  return result;
}

GaugeReadings read_gauges(Readings& readings, std::size_t stations, const std::string& time) {
  MeanReadings means(stations);
  GaugeReadings at_time;
  TimeStep step;
  while (readings.next(step)) {
    throw_if_interrupted();
    if (time.empty()) {
      means.add(step.readings);
    } else if (step.time == time) {
      at_time = {{step.readings.begin(), step.readings.end()}, step.time};
    }
  }
  return time.empty() ? means.result() : at_time;
}

}  // namespace thiessen
