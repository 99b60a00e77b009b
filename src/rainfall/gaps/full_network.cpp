#include "rainfall/gaps/full_network.h"

#include <cmath>
#include <map>

#include "geometry/long_sum.h"
#include "rainfall/network/mean_reading.h"

namespace thiessen {

FullNetwork::Reporting FullNetwork::reporting(const BasinWeights& full,
                                              std::span<const double> readings) {
  std::size_t gauges = 0;
  LongSum share;
  LongSum sum;
  for (const StationWeight& s : full.stations) {
    const double reading = readings[index(s.station)];
    if (std::isnan(reading)) continue;
    ++gauges;
    share.add(s.weight);
    sum.add(s.weight * s.factor * reading);
  }
  return {gauges, gauges > 0 && gauges == full.stations.size(), share.value(), sum.value()};
}

std::vector<BasinRainfall> FullNetwork::at(std::span<const double> readings) const {
  std::vector<BasinRainfall> result;
  result.reserve(full_.size());
  for (const BasinWeights& full : full_) {
    const Reporting of_basin = reporting(full, readings);
    result.push_back({value(of_basin), of_basin.gauges, 0});
  }
  return result;
}

std::vector<BasinRainfall> FullNetwork::at(std::span<const double> readings,
                                           CellAccount& account) const {
  account.readings = cell_readings(readings);
  account.change = change(readings);
  return at(readings);
}

std::vector<BasinWeights> FullNetwork::weights_at(std::span<const double> readings) const {
  std::vector<BasinWeights> result;
  result.reserve(full_.size());
  for (const BasinWeights& full : full_) result.push_back(weights(full, readings));
  return result;
}

std::vector<CellWeight> FullNetwork::full_cells() const {
  std::vector<CellWeight> cells;
  for (std::uint32_t b = 0; b < full_.size(); ++b) {
    std::map<PlaceIndex, LongSum> of_place;
    for (const StationWeight& s : full_[b].stations)
      of_place[network_.place_of(s.station)].add(s.weight);
    for (const auto& [place, weight] : of_place) cells.push_back({b, place, weight.value()});
  }
  return cells;
}

std::vector<double> FullNetwork::cell_readings(std::span<const double> readings) const {
  return readings_by_place(network_, readings);
}

}  // namespace thiessen
