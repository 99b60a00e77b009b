#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "geometry/long_sum.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// How many of the stations report. `readings` has one entry for each station of the network.
inline std::size_t count_reporting(std::span<const StationIndex> stations,
                                   std::span<const double> readings) {
  return static_cast<std::size_t>(
      std::count_if(stations.begin(), stations.end(),
                    [&](StationIndex s) { return !std::isnan(readings[index(s)]); }));
}

/// The mean reading of the stations that report; NaN where none does.
inline double mean_reading(std::span<const StationIndex> stations,
                           std::span<const double> readings) {
  if (stations.size() == 1) return readings[index(stations.front())];
  LongSum sum;
  std::size_t count = 0;
  for (const StationIndex s : stations) {
    const double reading = readings[index(s)];
    if (std::isnan(reading)) continue;
    sum.add(reading);
    ++count;
  }
  return count == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : sum.value() / static_cast<double>(count);
}

/// The mean reading at every place of a network; NaN where no station at the place reports.
inline std::vector<double> readings_by_place(const Network& network,
                                             std::span<const double> readings) {
  std::vector<double> means(network.places().size());
  for (std::uint32_t p = 0; p < means.size(); ++p)
    means[p] = mean_reading(network.stations_at(PlaceIndex{p}), readings);
  return means;
}

}  // namespace thiessen
