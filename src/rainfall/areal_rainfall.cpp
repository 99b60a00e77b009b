#include "rainfall/areal_rainfall.h"

#include <cmath>
#include <limits>

#include "geometry/long_sum.h"

namespace thiessen {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

std::size_t bytes_of(const std::vector<BasinWeights>& weights) {
  std::size_t bytes = weights.size() * sizeof(BasinWeights);
  for (const BasinWeights& basin : weights)
    bytes += basin.stations.capacity() * sizeof(StationWeight);
  return bytes;
}

double coverage(const BasinWeights& full, std::span<const double> readings) {
  LongSum sum;
  bool whole = true;
  for (const StationWeight& s : full.stations) {
    if (std::isnan(readings[index(s.station)])) {
      whole = false;
    } else {
      sum.add(s.weight);
    }
  }
  return whole && !full.stations.empty() ? 1 : sum.value();
}

}  // namespace

ArealRainfall::ArealRainfall(const Weighing& weighing, Gaps gaps, std::size_t min_gauges,
                             std::size_t remembered_bytes, unsigned threads)
    : weighing_(weighing),
      gaps_(gaps),
      min_gauges_(min_gauges),
      remembered_bytes_(remembered_bytes),
      full_(weighing.weights(std::vector<bool>(weighing.network().stations().size(), true),
                             threads)) {}

ArealRainfall::Weights ArealRainfall::weights_of(const std::vector<bool>& reports) const {
  {
    const std::lock_guard lock(mutex_);
    const auto found = remembered_.find(reports);
    if (found != remembered_.end()) return found->second;
  }
  auto weights = std::make_shared<const std::vector<BasinWeights>>(weighing_.weights(reports, 1));
  const std::size_t bytes = bytes_of(*weights) + reports.size() / 8;
  const std::lock_guard lock(mutex_);
  if (bytes_ + bytes <= remembered_bytes_ && remembered_.emplace(reports, weights).second)
    bytes_ += bytes;
  return weights;
}

BasinRainfall ArealRainfall::retessellated(const BasinWeights& weights,
                                           std::span<const double> readings) const {
  BasinRainfall result{0, weights.stations.size(), 0};
  LongSum sum;
  for (const StationWeight& s : weights.stations) sum.add(s.weight * readings[index(s.station)]);
  result.rainfall = sum.value();
  if (result.gauges == 0 || result.gauges < min_gauges_) result.rainfall = no_value;
  return result;
}

BasinRainfall ArealRainfall::from_full_network(const BasinWeights& weights,
                                               std::span<const double> readings) const {
  BasinRainfall result{0, 0, 0};
  LongSum reporting;
  LongSum sum;
  for (const StationWeight& s : weights.stations) {
    const double reading = readings[index(s.station)];
    if (std::isnan(reading)) continue;
    ++result.gauges;
    reporting.add(s.weight);
    sum.add(s.weight * reading);
  }
  const bool complete = result.gauges == weights.stations.size();
  result.rainfall = complete ? sum.value() : sum.value() / reporting.value();
  const bool refused = gaps_ == Gaps::strict && !complete;
  if (result.gauges == 0 || result.gauges < min_gauges_ || refused) result.rainfall = no_value;
  return result;
}

std::vector<BasinRainfall> ArealRainfall::at(std::span<const double> readings) const {
  Weights retessellation;
  if (gaps_ == Gaps::retessellate) {
    std::vector<bool> reports(readings.size());
    bool all = true;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      reports[i] = !std::isnan(readings[i]);
      all = all && reports[i];
    }
    if (!all) retessellation = weights_of(reports);
  }
  std::vector<BasinRainfall> result;
  result.reserve(full_.size());
  for (std::size_t b = 0; b < full_.size(); ++b) {
    const bool from_full = gaps_ != Gaps::retessellate;
    const BasinWeights& weights = retessellation ? (*retessellation)[b] : full_[b];
    result.push_back(from_full ? from_full_network(weights, readings)
                               : retessellated(weights, readings));
    result.back().coverage = coverage(full_[b], readings);
  }
  return result;
}

}  // namespace thiessen
