#include "rainfall/series/rain_statistics.h"

#include <algorithm>
#include <cmath>

namespace thiessen {

void RainStatistics::add(const std::vector<BasinRainfall>& step) {
  ++steps_;
  for (std::size_t b = 0; b < basins_.size(); ++b) {
    const double value = step[b].rainfall;
    OfBasin& basin = basins_[b];
    if (std::isnan(value)) {
      ++basin.empty;
      continue;
    }
    basin.largest = basin.values == 0 ? value : std::max(basin.largest, value);
    basin.sum += value;
    ++basin.values;
  }
}

}  // namespace thiessen
