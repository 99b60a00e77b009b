#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rainfall/findings/finding_search.h"
#include "rainfall/findings/gauge_neighbours.h"

namespace thiessen {

/// Looks for readings of 0 while it rained at all neighbours that report, of which at least four
/// read much, and at most one less.
///
/// One of many is often near the edge of a storm: to ask much of all finds a third less. But none
/// may be dry, for then the gauge may be dry, too.
class ZeroSearch : public FindingSearch {
 public:
  static constexpr double much_in_millimetres = 5;
  static constexpr std::size_t least_neighbours = 4;  ///< with much

  /// `much` is in the readings' unit.
  ZeroSearch(const GaugeNeighbours& neighbours, double much);

  void see(const SeenStep& step, const TakeFinding& take) override;
  using FindingSearch::see;

 private:
  // What a neighbour's reading says against a gauge's 0 being wrong: nothing where it is silent or
  // has much, 1 where it has less, 2 where it is dry.
  static constexpr unsigned most_doubts = 1;
  static constexpr unsigned doubts_of_zero = 2;

  struct Two {
    StationIndex first;
    StationIndex second;
  };

  bool rained_all_round(const SeenStep& step, StationIndex gauge) const;

  const GaugeNeighbours& neighbours_;
  double much_;
  std::vector<Two> first_two_;        // by gauge: of its neighbours; itself where these are too few
  std::vector<StationIndex> asked_;   // gauges that may be found at a step
  std::vector<std::uint8_t> doubts_;  // by gauge, of a step
};

}  // namespace thiessen
