#include "cli/outputs/shown_values.h"

#include <set>

namespace thiessen::cli {

std::vector<double> shown_values(const Inputs& inputs, const GaugeReadings& readings,
                                 unsigned threads) {
  std::set<StationIndex> owners;
  std::vector<double> values;
  const bool has_normals = inputs.weighing().normals() != nullptr;
  const auto cells =
      inputs.weighing().weights_in_month(readings.reports(), threads, readings.month);
  for (const BasinWeights& basin : cells) {
    for (const StationWeight& weight : basin.stations) {
      owners.insert(weight.station);
      if (has_normals) values.push_back(weight.factor * readings.readings[index(weight.station)]);
    }
  }
  if (has_normals) return values;
  values.reserve(owners.size());
  for (const StationIndex station : owners) values.push_back(readings.readings[index(station)]);
  return values;
}

}  // namespace thiessen::cli
