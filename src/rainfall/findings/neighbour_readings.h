#pragma once

#include <cstddef>
#include <vector>

#include "rainfall/findings/gauge_neighbours.h"
#include "rainfall/findings/seen_step.h"

namespace thiessen {

/// What a gauge's neighbours read at a step.
struct NeighbourReadings {
  std::size_t reporting = 0;
  double largest = 0;
};

inline NeighbourReadings neighbour_readings(const GaugeNeighbours& neighbours, const SeenStep& step,
                                            StationIndex gauge) {
  NeighbourReadings found;
  for (const GaugeNeighbours::Neighbour& neighbour : neighbours.of(gauge)) {
    const double reading = step.readings[index(neighbour.station)];
    found.reporting += reading == reading ? 1u : 0u;
    found.largest = reading > found.largest ? reading : found.largest;
  }
  return found;
}

/// The median of some values, the mean of the middle two where they are even in number; NaN of
/// none. Changes their order.
double median_of(std::vector<double>& values);

/// The median of what a gauge's neighbours read at a step; NaN where none reports.
double expected_reading(const GaugeNeighbours& neighbours, const SeenStep& step,
                        StationIndex gauge);

}  // namespace thiessen
