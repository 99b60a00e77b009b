#include "rainfall/full_network.h"

#include <cmath>
#include <limits>

#include "geometry/long_sum.h"

namespace thiessen {

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

BasinRainfall rainfall_of_full_network(const BasinWeights& full, std::span<const double> readings,
                                       Gaps gaps, std::size_t min_gauges) {
  BasinRainfall result{0, 0, 0};
  LongSum reporting;
  LongSum sum;
  for (const StationWeight& s : full.stations) {
    const double reading = readings[index(s.station)];
    if (std::isnan(reading)) continue;
    ++result.gauges;
    reporting.add(s.weight);
    sum.add(s.weight * reading);
  }
  const bool complete = result.gauges == full.stations.size();
  result.rainfall = complete ? sum.value() : sum.value() / reporting.value();
  const bool refused = gaps == Gaps::strict && !complete;
  if (result.gauges == 0 || result.gauges < min_gauges || refused)
    result.rainfall = std::numeric_limits<double>::quiet_NaN();
  return result;
}

BasinWeights weights_of_full_network(const BasinWeights& full, std::span<const double> readings,
                                     Gaps gaps) {
  BasinWeights weights{full.area, {}};
  LongSum reporting;
  for (const StationWeight& s : full.stations) {
    if (std::isnan(readings[index(s.station)])) continue;
    weights.stations.push_back(s);
    reporting.add(s.weight);
  }
  if (weights.stations.size() == full.stations.size()) return weights;
  if (gaps == Gaps::strict) weights.stations.clear();
  for (StationWeight& s : weights.stations) s.weight /= reporting.value();
  return weights;
}

}  // namespace thiessen
