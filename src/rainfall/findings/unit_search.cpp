#include "rainfall/findings/unit_search.h"

#include <cstdint>
#include <limits>

#include "rainfall/findings/neighbour_readings.h"

namespace thiessen {

double UnitSearch::times_neighbours(StationIndex gauge) const {
  std::vector<double> ratios;
  for (const GaugeNeighbours::Neighbour& neighbour : totals_.neighbours().of(gauge)) {
    if (totals_.wet_steps(neighbour.pair) < least_wet_steps) continue;
    const NeighbourTotals::Sums sums = totals_.of_all(neighbour.pair);
    const double own = neighbour.is_second ? sums.second : sums.first;
    const double other = neighbour.is_second ? sums.first : sums.second;
    // A neighbour that never has any tells nothing but that.
    ratios.push_back(other > 0 ? own / other : std::numeric_limits<double>::infinity());
  }
  if (ratios.size() < least_neighbours) return std::numeric_limits<double>::quiet_NaN();
  return median_of(ratios);
}

void UnitSearch::conclude(const TakeFinding& take) {
  for (std::uint32_t g = 0; g < totals_.neighbours().gauges(); ++g) {
    const double times = times_neighbours(StationIndex{g});
    if (times > most_times || times < 1 / most_times)
      take({StationIndex{g}, FindingKind::unit, "", times, 1});
  }
}

}  // namespace thiessen
