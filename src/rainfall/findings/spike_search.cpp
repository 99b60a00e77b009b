#include "rainfall/findings/spike_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rainfall/findings/neighbour_readings.h"

namespace thiessen {
namespace {

/// So many steps are counted one by one, and of those beyond each 32nd, which tells as much.
constexpr std::size_t steps_counted = 4096;
constexpr std::size_t least_amounts = 100;

}  // namespace

/// Counts what the gauges read. What cannot be above the bound in the end is told by what gauges
/// read so far: by the median gauge, which those in another unit do not move.
void SpikeSearch::watch(const SeenStep& step) {
  ++steps_;
  if (steps_ > steps_counted && steps_ % 32 != 0) return;
  for (const StationIndex gauge : step.wet) amounts_.add(gauge, step.readings[index(gauge)]);
  if (steps_ < next_look_) return;
  next_look_ = 2 * steps_;
  const double usual = amounts_.median_quantile(0.97, least_amounts);
  if (!std::isnan(usual)) least_ = std::max(least_, 0.75 * usual);
}

void SpikeSearch::see(const SeenStep& step, const TakeFinding& take) {
  if (!bound_) watch(step);
  const double least = bound_.value_or(least_);
  for (const StationIndex gauge : step.wet) {
    const double reading = step.readings[index(gauge)];
    if (!(reading > least)) continue;
    const NeighbourReadings found = neighbour_readings(neighbours_, step, gauge);
    if (found.reporting < least_neighbours || !(excess(reading, found.largest) > least)) continue;
    take({gauge, FindingKind::spike, step.time, reading, expected_reading(neighbours_, step, gauge),
          0, excess(reading, found.largest)});
  }
}

void SpikeSearch::settle(const std::function<bool(StationIndex)>& counts) {
  if (bound_) return;
  const bool is_known = amounts_.count() >= least_amounts;
  const double tail = is_known ? amounts_.quantile(0.99, counts) : NAN;
  bound_ = std::isnan(tail) ? tail : std::max(tail, least_);
}

double SpikeSearch::bound() const {
  return bound_.value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace thiessen
