#include "rainfall/gaps/renormalisation.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/long_sum.h"

namespace thiessen {

double Renormalisation::value(const Reporting& reporting) const {
  if (reporting.gauges == 0) return std::numeric_limits<double>::quiet_NaN();
  return reporting.complete ? reporting.sum : reporting.sum / reporting.share;
}

BasinWeights Renormalisation::weights(const BasinWeights& full,
                                      std::span<const double> readings) const {
  BasinWeights weights{full.area, {}};
  LongSum share;
  for (const StationWeight& s : full.stations) {
    if (std::isnan(readings[index(s.station)])) continue;
    weights.stations.push_back(s);
    share.add(s.weight);
  }
  if (weights.stations.size() == full.stations.size()) return weights;
  for (StationWeight& s : weights.stations) s.weight /= share.value();
  return weights;
}

std::vector<CellWeight> Renormalisation::change(std::span<const double> readings) const {
  std::vector<CellWeight> change;
  for (std::uint32_t b = 0; b < full_weights().size(); ++b) {
    for (const StationWeight& s : full_weights()[b].stations) {
      if (std::isnan(readings[index(s.station)]))
        change.push_back({b, network().place_of(s.station), -s.weight});
    }
  }
  return change;
}

}  // namespace thiessen
