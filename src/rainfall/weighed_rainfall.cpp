#include "rainfall/weighed_rainfall.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/long_sum.h"
#include "rainfall/gaps/gap_policies.h"

namespace thiessen {
namespace {

/// The share of a basin that the full network gives to gauges that report. It is exactly 1 where
/// all report, whatever the weights add up to.
double coverage(const BasinWeights& full, std::span<const double> readings) {
  const auto reports = [&](const StationWeight& s) {
    return !std::isnan(readings[index(s.station)]);
  };
  if (full.stations.empty()) return 0;
  if (std::all_of(full.stations.begin(), full.stations.end(), reports)) return 1;
  LongSum sum;
  for (const StationWeight& s : full.stations) {
    if (reports(s)) sum.add(s.weight);
  }
  return sum.value();
}

}  // namespace

WeighedRainfall::WeighedRainfall(std::shared_ptr<const Weigher> weigher,
                                 const ArealRainfallSettings& settings, const NormalMonth& month)
    : settings_(settings),
      weigher_(std::move(weigher)),
      policy_(gap_policy(settings.gaps, *weigher_, month)) {}

void WeighedRainfall::finish(std::vector<BasinRainfall>& values,
                             std::span<const double> readings) const {
  for (std::size_t b = 0; b < values.size(); ++b) {
    BasinRainfall& basin = values[b];
    if (settings_.counts_gauges() && basin.gauges < settings_.min_gauges)
      basin.rainfall = std::numeric_limits<double>::quiet_NaN();
    if (settings_.accounts) basin.coverage = coverage(full_weights()[b], readings);
  }
}

std::vector<BasinRainfall> WeighedRainfall::at(std::span<const double> readings) const {
  std::vector<BasinRainfall> values = policy_->at(readings);
  finish(values, readings);
  return values;
}

std::vector<BasinRainfall> WeighedRainfall::at(std::span<const double> readings,
                                               CellAccount& account) const {
  std::vector<BasinRainfall> values = policy_->at(readings, account);
  finish(values, readings);
  return values;
}

std::vector<BasinWeights> WeighedRainfall::weights_at(std::span<const double> readings) const {
  std::vector<BasinWeights> weights = policy_->weights_at(readings);
  for (BasinWeights& basin : weights) {
    if (basin.stations.size() < settings_.min_gauges) basin.stations.clear();
  }
  return weights;
}

}  // namespace thiessen
