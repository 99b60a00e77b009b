#include "study/plane_error.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_id = 80;

/// How far an area is off, the same for one twice too large and one half as large.
double strain(double factor) {
  return std::abs(std::log(factor));
}

/// Calls `see(station, in_plane, on_earth)` for every gauge that has a weight on either side.
template <typename See>
void for_each_pair(const BasinWeights& in_plane, const BasinWeights& on_earth, const See& see) {
  auto a = in_plane.stations.begin();
  auto b = on_earth.stations.begin();
  while (a != in_plane.stations.end() || b != on_earth.stations.end()) {
    const bool has_a = a != in_plane.stations.end();
    const bool has_b = b != on_earth.stations.end();
    if (has_a && has_b && a->station == b->station) {
      see(a->station, a->weight, b->weight);
      ++a;
      ++b;
    } else if (has_a && (!has_b || a->station < b->station)) {
      see(a->station, a->weight, 0.0);
      ++a;
    } else {
      see(b->station, 0.0, b->weight);
      ++b;
    }
  }
}

/// The decimals with which a number shows two digits that tell, and at least four.
int decimals_for(double value) {
  if (!(value > 0)) return 4;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(value))), 4, 15);
}

std::string factor_text(double factor) {
  return fixed_text(factor, strain(factor) < 0.1 ? 4 : 2);
}

std::string basin_text(const Study& study, std::size_t basin) {
  if (!study.parts().has_basins) return "the study area";
  return "basin " + quoted(study.basins()[basin].id, longest_id);
}

}  // namespace

bool PlaneError::distorts_areas() const {
  return worst_area && strain(worst_area->factor) > area_to_warn_of;
}

PlaneError error_of_plane(std::span<const BasinWeights> in_plane,
                          std::span<const BasinWeights> on_earth, bool areas_in_metres) {
  PlaneError error;
  double worst = -1;
  for (std::size_t b = 0; b < in_plane.size(); ++b) {
    for_each_pair(in_plane[b], on_earth[b], [&](StationIndex station, double plane, double earth) {
      const PlaneError::Change change{b, station, plane, earth};
      if (change.size() <= worst) return;
      worst = change.size();
      error.worst_change = change;
    });
    if (!areas_in_metres || !(on_earth[b].area > 0)) continue;
    const PlaneError::AreaFactor area{b, in_plane[b].area / on_earth[b].area};
    if (!error.worst_area || strain(area.factor) > strain(error.worst_area->factor))
      error.worst_area = area;
  }
  return error;
}

PlaneError error_of_plane(const Study& study, StudyParts on_earth, unsigned threads) {
  const Yardstick yardstick{Metric::geodesic, 1, Yardstick::measuring_tolerance};
  const Network network(std::move(on_earth.stations), Metric::geodesic);
  const Weighing weighing(network, on_earth.basins, yardstick);
  const ReportingStations all = study.all_report();
  return error_of_plane(study.weighing().weights(all, threads), weighing.weights(all, threads),
                        study.parts().metres_per_unit.has_value());
}

std::string sentence_of(const PlaneError& error, const Study& study) {
  const PlaneError::Change& change = error.worst_change;
  const Station& station = study.network().stations()[index(change.station)];
  const int decimals = decimals_for(change.size());
  std::string text = "weights are those on the Earth";
  if (change.size() > 0) {
    text = "weights are off by up to " + fixed_text(change.size(), decimals) + " (station " +
           quoted(station.id, longest_id) + " in " + basin_text(study, change.basin) + ": " +
           fixed_text(change.in_plane, decimals) + ", on the Earth " +
           fixed_text(change.on_earth, decimals) + ")";
  }
  if (!error.worst_area) return text;
  return text + ", areas by a factor of " + factor_text(error.worst_area->factor) + " (" +
         basin_text(study, error.worst_area->basin) + ")";
}

}  // namespace thiessen
