#pragma once

#include <cstddef>
#include <vector>

#include "rainfall/findings/finding_search.h"
#include "rainfall/findings/gauge_neighbours.h"

namespace thiessen {

/// Looks for readings of 0 while all neighbours that report, four at least, read much.
class ZeroSearch : public FindingSearch {
 public:
  static constexpr double much_in_millimetres = 5;
  static constexpr std::size_t least_neighbours = 4;

  /// `much` is in the readings' unit.
  ZeroSearch(const GaugeNeighbours& neighbours, double much);

  void see(const SeenStep& step, const TakeFinding& take) override;
  using FindingSearch::see;

 private:
  bool do_all_read_much(const SeenStep& step, StationIndex gauge) const;

  const GaugeNeighbours& neighbours_;
  double much_;
  std::vector<StationIndex> first_;  // by gauge: its first neighbour, or itself
  std::vector<StationIndex> asked_;  // gauges that may be found at a step
};

}  // namespace thiessen
