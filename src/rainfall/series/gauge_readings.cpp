#include "rainfall/series/gauge_readings.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/interrupt.h"
#include "base/iso_time.h"
#include "rainfall/network/mean_reading.h"
#include "rainfall/series/step_months.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The readings of a step, each gauge's replaced by the mean of those at its place.
std::vector<double> values_of(const Network& network, std::span<const double> readings) {
  const std::vector<double> at_place = readings_by_place(network, readings);
  std::vector<double> values(readings.size(), none);
  for (std::uint32_t s = 0; s < values.size(); ++s) {
    if (!std::isnan(readings[s])) values[s] = at_place[index(network.place_of(StationIndex{s}))];
  }
  return values;
}

}  // namespace

MeanReadings::MeanReadings(const Network& network)
    : network_(network),
      sum_(network.places().size()),
      count_(network.places().size(), 0),
      heard_(network.stations().size(), false) {}

void MeanReadings::add(std::span<const double> readings) {
  ++steps_;
  for (std::uint32_t s = 0; s < readings.size(); ++s) {
    if (!std::isnan(readings[s])) heard_.set(StationIndex{s}, true);
  }
  for (std::uint32_t p = 0; p < sum_.size(); ++p) {
    const double value = mean_reading(network_.stations_at(PlaceIndex{p}), readings);
    if (std::isnan(value)) continue;
    sum_[p].add(value);
    ++count_[p];
  }
}

void MeanReadings::note(const std::string& name, const ParsedTime& time) {
  name_ = name;
  intervals_.note(time);
}

std::optional<StepLength> MeanReadings::step() const {
  return intervals_.step();
}

double MeanReadings::mean_at(PlaceIndex place) const {
  const std::size_t count = count_[index(place)];
  return count == 0 ? none : sum_[index(place)].value() / static_cast<double>(count);
}

std::string MeanReadings::label() const {
  if (steps_ == 1) return name_;
  return "each gauge's mean over the steps it reports, of " + std::to_string(steps_) +
         " time steps";
}

GaugeReadings MeanReadings::of_reporting() const {
  GaugeReadings result = of_all();
  for (std::uint32_t s = 0; s < result.readings.size(); ++s) {
    if (!heard_[StationIndex{s}]) result.readings[s] = none;
  }
  return result;
}

GaugeReadings MeanReadings::of_all() const {
  GaugeReadings result;
  result.label = label();
  result.step = step();
  for (std::uint32_t s = 0; s < heard_.size(); ++s)
    result.readings.push_back(mean_at(network_.place_of(StationIndex{s})));
  return result;
}

std::vector<GaugeReadings> read_steps(Readings& readings, const Network& network,
                                      std::span<const std::string> times) {
  std::vector<GaugeReadings> steps(times.size());
  StepIntervals intervals;
  TimeStep step;
  while (readings.next(step)) {
    throw_if_interrupted();
    intervals.note(calendar_time(step.time, step.written));
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (step.time != times[i]) continue;
      steps[i] = {values_of(network, step.readings), step.time, {}};
      steps[i].month = month_of(step.time, step.written, readings.stamp().value_or(Stamp::begin));
    }
  }
  for (GaugeReadings& shown : steps) {
    shown.step = intervals.step();
    shown.unit = readings.unit();
  }
  return steps;
}

GaugeReadings read_gauges(Readings& readings, const Network& network, const std::string& time) {
  if (!time.empty()) return std::move(read_steps(readings, network, {&time, 1}).front());
  MeanReadings means(network);
  TimeStep step;
  while (readings.next(step)) {
    throw_if_interrupted();
    means.note(step.time, calendar_time(step.time, step.written));
    means.add(step.readings);
  }
  GaugeReadings shown = means.of_reporting();
  shown.unit = readings.unit();
  return shown;
}

}  // namespace thiessen
