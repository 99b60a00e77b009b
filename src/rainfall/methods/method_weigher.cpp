#include "rainfall/methods/method_weigher.h"

#include <utility>

#include "rainfall/methods/method_retessellation.h"

namespace thiessen {

MethodWeigher::MethodWeigher(const Weighing& weighing, std::shared_ptr<const AreaMethod> method,
                             std::size_t remembered_bytes)
    : weighing_(weighing), method_(std::move(method)), remembered_bytes_(remembered_bytes) {}

AreaMethod::Weights MethodWeigher::full_places(const NormalMonth& month) const {
  return method_->weights(ReportingPlaces(network().places().size(), true), month);
}

std::vector<BasinWeights> MethodWeigher::full_weights(const NormalMonth& month) const {
  return by_station(full_places(month), ReportingStations(network().stations().size(), true),
                    month);
}

std::unique_ptr<const Retessellation> MethodWeigher::retessellation(
    const NormalMonth& month) const {
  return std::make_unique<const MethodRetessellation>(*this, *method_, month, remembered_bytes_);
}

std::vector<BasinWeights> MethodWeigher::by_station(const AreaMethod::Weights& weights,
                                                    const ReportingStations& stations_report,
                                                    const NormalMonth& month) const {
  std::vector<BasinWeights> result(weights.size());
  std::vector<StationIndex> reporting;
  for (std::size_t b = 0; b < weights.size(); ++b) {
    BasinWeights& basin = result[b];
    basin.area = weighing_.basin_area(b);
    for (const PlaceWeight& w : weights[b]) {
      reporting.clear();
      for (const StationIndex s : network().stations_at(w.place)) {
        if (stations_report[s]) reporting.push_back(s);
      }
      const double weight = w.weight / static_cast<double>(reporting.size());
      for (const StationIndex s : reporting)
        basin.stations.push_back({s, weight * basin.area, weight});
      if (normals() == nullptr) continue;
      set_factors(basin, reporting, w.normal * reference_normal(*normals(), month), *normals(),
                  month);
    }
    sort_by_station(basin.stations);
  }
  return result;
}

}  // namespace thiessen
