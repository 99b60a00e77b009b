#include "cli/outputs/shown_values.h"

#include <set>

namespace thiessen::cli {

std::vector<double> shown_values(const Inputs& inputs, const GaugeReadings& readings,
                                 unsigned threads) {
  std::set<StationIndex> owners;
  for (const BasinWeights& basin : inputs.weighing().weights(readings.reports(), threads)) {
    for (const StationWeight& weight : basin.stations) owners.insert(weight.station);
  }
  std::vector<double> values;
  values.reserve(owners.size());
  for (const StationIndex station : owners) values.push_back(readings.readings[index(station)]);
  return values;
}

}  // namespace thiessen::cli
