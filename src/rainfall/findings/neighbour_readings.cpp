#include "rainfall/findings/neighbour_readings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thiessen {

double median_of(std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  if (values.size() % 2 == 1 || values[middle - 1] == values[middle]) return values[middle];
  return (values[middle - 1] + values[middle]) / 2;
}

double expected_reading(const GaugeNeighbours& neighbours, const SeenStep& step,
                        StationIndex gauge) {
  std::vector<double> readings;
  for (const GaugeNeighbours::Neighbour& neighbour : neighbours.of(gauge)) {
    const double reading = step.readings[index(neighbour.station)];
    if (!std::isnan(reading)) readings.push_back(reading);
  }
  return median_of(readings);
}

}  // namespace thiessen
