#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rainfall/findings/finding_search.h"
#include "rainfall/findings/neighbour_totals.h"

namespace thiessen {

/// Looks for gauges that from some year on catch more, or less, beside their neighbours than
/// before: by the yearly ratios to each neighbour, of which the median neighbour's counts; with the
/// standard normal homogeneity test, and where the slope of the double mass curve changes by more
/// than a fifth. Wants 15 years in which three neighbours can tell; a year counts for a pair that
/// reports together in at least half as many steps as in its fullest year.
class BreakSearch : public FindingSearch {
 public:
  static constexpr std::size_t least_years = 15;
  static constexpr std::size_t least_neighbours = 2;
  static constexpr std::size_t least_years_on_a_side = 3;
  static constexpr double least_statistic = 12;
  static constexpr double least_ratio = 1.2;

  /// The totals are filled by somebody else.
  explicit BreakSearch(const NeighbourTotals& totals) : totals_(totals) {}

  void conclude(const TakeFinding& take) override;

 private:
  struct Yearly;

  Yearly yearly(const GaugeNeighbours::Neighbour& neighbour) const;
  std::optional<ReadingFinding> break_of(StationIndex gauge) const;

  const NeighbourTotals& totals_;
};

}  // namespace thiessen
