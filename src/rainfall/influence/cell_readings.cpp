#include "rainfall/influence/cell_readings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "geometry/long_sum.h"

namespace thiessen {
namespace {

// One thread takes this many steps together, for their values share lines of memory.
constexpr std::size_t steps_together = 16;

}  // namespace

void CellReadings::take_up(StepRows rows, unsigned threads) {
  const std::size_t cells = adjacency_.cells();
  steps_.assign(rows.size(), {});
  values_.assign(cells * rows.size(), std::numeric_limits<double>::quiet_NaN());
  component_.resize(values_.size());
  const std::size_t batches = (rows.size() + steps_together - 1) / steps_together;
  in_parallel(batches, threads, [&](std::size_t, std::size_t batch) {
    const std::size_t end = std::min(rows.size(), (batch + 1) * steps_together);
    for (std::size_t step = batch * steps_together; step < end; ++step) take_up(step, rows[step]);
  });
}

void CellReadings::take_up(std::size_t step, std::span<const double> readings) {
  std::vector<PlaceIndex> silent;
  for (std::uint32_t cell = 0; cell < adjacency_.cells(); ++cell) {
    const auto stations = cells_.stations_of(PlaceIndex{cell});
    if (stations.empty()) continue;
    double first = 0;
    LongSum above_first;  // so that equal readings have exactly their own mean
    std::size_t count = 0;
    for (const StationIndex s : stations) {
      const double reading = relative(s, readings[index(s)]);
      if (std::isnan(reading)) continue;
      if (count == 0) first = reading;
      above_first.add(reading - first);
      ++count;
    }
    steps_[step].reporting += count;
    if (count == 0) {
      silent.push_back(PlaceIndex{cell});
    } else {
      values_[cell * steps() + step] = first + above_first.value() / static_cast<double>(count);
    }
  }
  std::vector<std::vector<PlaceIndex>>& components = steps_[step].components;
  components = components_of(silent, adjacency_);
  for (std::uint32_t i = 0; i < components.size(); ++i) {
    for (const PlaceIndex cell : components[i]) component_[index(cell) * steps() + step] = i;
  }
}

}  // namespace thiessen
