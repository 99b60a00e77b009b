#pragma once

#include <cstddef>
#include <vector>

#include "rainfall/findings/finding_search.h"
#include "rainfall/findings/neighbour_totals.h"

namespace thiessen {

/// Looks for gauges all of whose rain is more than four times that of their neighbours, or less
/// than a quarter, as it is in another unit: by the median of the ratios to each neighbour of what
/// both read while both reported. At least three neighbours have to have 30 such steps with rain.
class UnitSearch : public FindingSearch {
 public:
  static constexpr double most_times = 4;
  static constexpr std::size_t least_neighbours = 3;
  static constexpr std::size_t least_wet_steps = 30;

  /// The totals are filled by somebody else.
  explicit UnitSearch(const NeighbourTotals& totals) : totals_(totals) {}

  void conclude(const TakeFinding& take) override;

  /// How many times the rain of its neighbours a gauge has; NaN where too few can tell.
  double times_neighbours(StationIndex gauge) const;

 private:
  const NeighbourTotals& totals_;
};

}  // namespace thiessen
