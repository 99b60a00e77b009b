#include "rainfall/normals/elevation_normals.h"

#include <cstdint>
#include <utility>

namespace thiessen {

ElevationNormals::ElevationNormals(std::shared_ptr<const ElevationFit> fit, const Network& network,
                                   std::shared_ptr<const NormalField> ground,
                                   std::span<const std::vector<double>> log_variances)
    : fit_(std::move(fit)), network_(network), ground_(std::move(ground)) {
  basins_.reserve(log_variances.size());
  for (std::size_t b = 0; b < log_variances.size(); ++b)
    basins_.emplace_back(ground_->in(b), log_variances[b]);
}

std::vector<std::vector<double>> normals_at_stations(const ElevationFit& fit,
                                                     const Network& network) {
  std::vector<std::vector<double>> normals;
  for (std::uint32_t s = 0; s < network.stations().size(); ++s) {
    std::vector<double>& of_station = normals.emplace_back();
    const std::size_t place = index(network.place_of(StationIndex{s}));
    for (std::size_t m = 0; m < fit.months(); ++m) of_station.push_back(fit.at_place(place, m));
  }
  return normals;
}

}  // namespace thiessen
