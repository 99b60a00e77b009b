#include "rainfall/methods/method_retessellation.h"

#include <cstdint>
#include <limits>

#include "geometry/long_sum.h"
#include "rainfall/network/mean_reading.h"
#include "rainfall/network/reporting.h"

namespace thiessen {
namespace {

/// The stations at a place at one step: how many report, and their mean reading.
struct PlaceReading {
  double mean = 0;
  std::size_t reporting = 0;
};

void append(std::vector<CellWeight>& cells, const AreaMethod::Weights& weights, double sign) {
  for (std::uint32_t b = 0; b < weights.size(); ++b) {
    for (const PlaceWeight& w : weights[b]) cells.push_back({b, w.place, sign * w.weight});
  }
}

}  // namespace

MethodRetessellation::MethodRetessellation(const MethodWeigher& weigher, const AreaMethod& method,
                                           const NormalMonth& month, std::size_t remembered_bytes)
    : weigher_(weigher),
      month_(month),
      at_gauges_(weigher.network().stations().size(), 1),
      full_places_(weigher.full_places(month)),
      full_(weigher.by_station(
          full_places_, ReportingStations(weigher.network().stations().size(), true), month)),
      remembered_(method, remembered_bytes, month) {
  if (weigher.normals() == nullptr) return;
  for (std::uint32_t s = 0; s < at_gauges_.size(); ++s)
    at_gauges_[s] = relative_at_gauge(*weigher.normals(), StationIndex{s}, month);
}

MethodRetessellation::StepWeights MethodRetessellation::weights_of(
    std::span<const double> readings) const {
  return remembered_.of(reporting_places(weigher_.network(), readings));
}

std::vector<BasinRainfall> MethodRetessellation::rainfall(const AreaMethod::Weights& weights,
                                                          std::span<const double> readings) const {
  const Network& network = weigher_.network();
  std::vector<PlaceReading> known(network.places().size());
  std::vector<double> relative(readings.begin(), readings.end());
  for (std::size_t s = 0; s < relative.size(); ++s) relative[s] /= at_gauges_[s];
  std::vector<BasinRainfall> result;
  result.reserve(weights.size());
  for (const auto& basin : weights) {
    LongSum sum;
    std::size_t gauges = 0;
    for (const PlaceWeight& w : basin) {
      PlaceReading& place = known[index(w.place)];
      if (place.reporting == 0) {
        const auto stations = network.stations_at(w.place);
        place = {mean_reading(stations, relative), count_reporting(stations, readings)};
      }
      sum.add(w.weight * w.normal * place.mean);
      gauges += place.reporting;
    }
    const double none = std::numeric_limits<double>::quiet_NaN();
    result.push_back({gauges > 0 ? sum.value() : none, gauges, 0});
  }
  return result;
}

std::vector<BasinRainfall> MethodRetessellation::at(std::span<const double> readings) const {
  return rainfall(*weights_of(readings), readings);
}

std::vector<BasinRainfall> MethodRetessellation::at(std::span<const double> readings,
                                                    CellAccount& account) const {
  const StepWeights weights = weights_of(readings);
  account.readings = cell_readings(readings);
  account.change.clear();
  append(account.change, full_places_, -1);
  append(account.change, *weights, 1);
  return rainfall(*weights, readings);
}

std::vector<BasinWeights> MethodRetessellation::weights_at(std::span<const double> readings) const {
  return weigher_.by_station(*weights_of(readings), reporting_stations(readings), month_);
}

std::vector<CellWeight> MethodRetessellation::full_cells() const {
  std::vector<CellWeight> cells;
  append(cells, full_places_, 1);
  return cells;
}

std::vector<double> MethodRetessellation::cell_readings(std::span<const double> readings) const {
  return readings_by_place(weigher_.network(), readings);
}

}  // namespace thiessen
