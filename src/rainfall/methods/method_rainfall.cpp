#include "rainfall/methods/method_rainfall.h"

#include <cmath>
#include <limits>
#include <utility>

#include "geometry/long_sum.h"

namespace thiessen {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// What the stations at a place say: how many report, and their mean.
struct PlaceReading {
  double mean = no_value;
  std::size_t reporting = 0;
};

PlaceReading reading_at(const Network& network, PlaceIndex place,
                        std::span<const double> readings) {
  LongSum sum;
  PlaceReading reading;
  for (const StationIndex s : network.stations_at(place)) {
    if (std::isnan(readings[index(s)])) continue;
    sum.add(readings[index(s)]);
    ++reading.reporting;
  }
  if (reading.reporting > 0) reading.mean = sum.value() / static_cast<double>(reading.reporting);
  return reading;
}

template <typename Value, typename Of>
std::vector<Value> interleaved(const std::vector<std::unique_ptr<const StepRainfall>>& methods,
                               const Of& of) {
  std::vector<std::vector<Value>> all;
  all.reserve(methods.size());
  for (const auto& method : methods) all.push_back(of(*method));
  std::vector<Value> series;
  series.reserve(methods.size() * all.front().size());
  for (std::size_t b = 0; b < all.front().size(); ++b) {
    for (auto& values : all) series.push_back(std::move(values[b]));
  }
  return series;
}

}  // namespace

MethodRainfall::MethodRainfall(const Weighing& weighing, std::unique_ptr<const AreaMethod> method,
                               const ArealRainfallSettings& settings)
    : weighing_(weighing),
      method_(std::move(method)),
      settings_(settings),
      remembered_(*method_, settings.remembered_bytes) {
  full_ = by_station(method_->weights(std::vector<bool>(weighing.network().places().size(), true)),
                     std::vector<bool>(weighing.network().stations().size(), true));
}

std::vector<bool> MethodRainfall::reports(std::span<const double> readings) const {
  const Network& network = weighing_.network();
  std::vector<bool> reports(network.places().size(), false);
  for (std::uint32_t s = 0; s < readings.size(); ++s) {
    if (!std::isnan(readings[s])) reports[index(network.place_of(StationIndex{s}))] = true;
  }
  return reports;
}

std::vector<BasinWeights> MethodRainfall::by_station(const AreaMethod::Weights& weights,
                                                     const std::vector<bool>& reports) const {
  std::vector<BasinWeights> result(weights.size());
  std::vector<StationIndex> reporting;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    BasinWeights& basin = result[b];
    basin.area = weighing_.basin_area(b);
    for (const PlaceWeight& w : weights[b]) {
      reporting.clear();
      for (const StationIndex s : weighing_.network().stations_at(w.place)) {
        if (reports[index(s)]) reporting.push_back(s);
      }
      const double weight = w.weight / static_cast<double>(reporting.size());
      for (const StationIndex s : reporting)
        basin.stations.push_back({s, weight * basin.area, weight});
    }
    sort_by_station(basin.stations);
  }
  return result;
}

std::vector<BasinRainfall> MethodRainfall::of_reporting(std::span<const double> readings) const {
  const auto weights = remembered_.of(reports(readings));
  std::vector<PlaceReading> known(weighing_.network().places().size());
  std::vector<BasinRainfall> result;
  result.reserve(weights->size());
  for (const auto& basin : *weights) {
    LongSum sum;
    std::size_t gauges = 0;
    for (const PlaceWeight& w : basin) {
      PlaceReading& reading = known[index(w.place)];
      if (reading.reporting == 0) reading = reading_at(weighing_.network(), w.place, readings);
      sum.add(w.weight * reading.mean);
      gauges += reading.reporting;
    }
    const bool has_value = gauges > 0 && gauges >= settings_.min_gauges;
    result.push_back({has_value ? sum.value() : no_value, gauges, 0});
  }
  return result;
}

std::vector<BasinRainfall> MethodRainfall::at(std::span<const double> readings) const {
  std::vector<BasinRainfall> result;
  if (settings_.gaps == Gaps::retessellate) {
    result = of_reporting(readings);
  } else {
    for (const BasinWeights& full : full_) {
      result.push_back(
          rainfall_of_full_network(full, readings, settings_.gaps, settings_.min_gauges));
    }
  }
  for (std::size_t b = 0; settings_.accounts && b < full_.size(); ++b)
    result[b].coverage = coverage(full_[b], readings);
  return result;
}

std::vector<BasinWeights> MethodRainfall::weights_at(std::span<const double> readings) const {
  std::vector<BasinWeights> weights;
  if (settings_.gaps == Gaps::retessellate) {
    std::vector<bool> stations;
    for (const double reading : readings) stations.push_back(!std::isnan(reading));
    weights = by_station(*remembered_.of(reports(readings)), stations);
  } else {
    for (const BasinWeights& full : full_)
      weights.push_back(weights_of_full_network(full, readings, settings_.gaps));
  }
  for (BasinWeights& basin : weights) {
    if (basin.stations.size() < settings_.min_gauges) basin.stations.clear();
  }
  return weights;
}

std::vector<BasinRainfall> SeveralMethods::at(std::span<const double> readings) const {
  return interleaved<BasinRainfall>(
      methods_, [&](const StepRainfall& method) { return method.at(readings); });
}

std::vector<BasinWeights> SeveralMethods::weights_at(std::span<const double> readings) const {
  return interleaved<BasinWeights>(
      methods_, [&](const StepRainfall& method) { return method.weights_at(readings); });
}

}  // namespace thiessen
