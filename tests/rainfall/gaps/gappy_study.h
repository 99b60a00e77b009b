#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "basin/shapes.h"
#include "geometry/seeded.h"
#include "rainfall/gaps/cell_weigher.h"
#include "rainfall/gaps/gap_policies.h"
#include "rainfall/methods/arithmetic_mean.h"
#include "rainfall/methods/inverse_distance.h"
#include "rainfall/methods/method_weigher.h"

namespace thiessen::gappy {

inline constexpr double silent = std::numeric_limits<double>::quiet_NaN();
inline constexpr Yardstick plane{Metric::planar, 1, 0.1};

/// Basins in a plane, with gauges in and around them, two of which share a place.
struct Study {
  Study(std::vector<Station> stations, std::vector<Basin> areas)
      : network(std::move(stations), Metric::planar),
        basins(std::move(areas)),
        weighing(network, basins, plane) {}

  /// The same without the gauges that are silent.
  Study without_silent(std::span<const double> readings) const {
    std::vector<Station> rest;
    for (std::size_t s = 0; s < readings.size(); ++s) {
      if (!std::isnan(readings[s])) rest.push_back(network.stations()[s]);
    }
    return {rest, basins};
  }

  Network network;
  std::vector<Basin> basins;
  Weighing weighing;
};

inline Study random_study(Seeded& seeded) {
  std::vector<Station> stations;
  for (int i = 0; i < 40; ++i)
    stations.push_back({std::to_string(i), {seeded.uniform(0, 5), seeded.uniform(0, 5)}, 0});
  stations.push_back({"twin", stations[3].position, 0});
  std::vector<Basin> basins;
  for (int i = 0; i < 5; ++i) {
    const Point centre{seeded.uniform(1, 4), seeded.uniform(1, 4)};
    basins.push_back(shapes::basin({{shapes::star(seeded, centre, 1.5, 20), {}}}));
  }
  return {stations, basins};
}

inline std::vector<double> readings_of(Seeded& seeded, const Study& study, double silent_share) {
  std::vector<double> readings(study.network.stations().size());
  for (double& reading : readings)
    reading = seeded.uniform(0, 1) < silent_share ? silent : seeded.uniform(0, 100);
  return readings;
}

inline std::vector<double> reported(std::span<const double> readings) {
  std::vector<double> rest;
  for (const double reading : readings) {
    if (!std::isnan(reading)) rest.push_back(reading);
  }
  return rest;
}

/// The cells, and methods that are not cells.
inline std::vector<std::unique_ptr<const Weigher>> weighers(const Study& study) {
  std::vector<std::unique_ptr<const Weigher>> all;
  all.push_back(std::make_unique<const CellWeigher>(
      study.weighing, CellWeigher::Keeping{std::size_t{1} << 20, true}, 1));
  all.push_back(std::make_unique<const MethodWeigher>(
      study.weighing, std::make_unique<const ArithmeticMean>(study.weighing), 1000));
  all.push_back(std::make_unique<const MethodWeigher>(
      study.weighing, std::make_unique<const InverseDistance>(study.weighing, 50, 1), 1000));
  return all;
}

}  // namespace thiessen::gappy
