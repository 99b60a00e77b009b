#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "rainfall/findings/finding_search.h"
#include "rainfall/findings/gauge_neighbours.h"
#include "rainfall/findings/wet_amounts.h"

namespace thiessen {

/// Looks for readings that are above three times the largest of the neighbours' by more than a
/// bound. At least three neighbours have to report.
///
/// The bound is given, or it is the 99 % quantile of all that the network's gauges read where it
/// rains. That is known only at the end: until then what is found is what may be above it, and the
/// bound says which of it is, by ReadingFinding::excess.
class SpikeSearch : public FindingSearch {
 public:
  static constexpr double times_neighbours = 3;
  static constexpr std::size_t least_neighbours = 3;

  SpikeSearch(const GaugeNeighbours& neighbours, std::optional<double> bound)
      : neighbours_(neighbours), bound_(bound), amounts_(bound ? 0 : neighbours.gauges()) {}

  void see(const SeenStep& step, const TakeFinding& take) override;
  using FindingSearch::see;

  /// Settles the bound, where none is given, by the gauges that count.
  void settle(const std::function<bool(StationIndex)>& counts);
  /// The bound, once it is settled; NaN where there are too few wet readings to tell it.
  double bound() const;
  /// How far a reading is above three times the largest of its neighbours.
  static double excess(double reading, double largest) {
    return reading - times_neighbours * largest;
  }

 private:
  void watch(const SeenStep& step);

  const GaugeNeighbours& neighbours_;
  std::optional<double> bound_;
  WetAmounts amounts_;
  double least_ = 0;  ///< what is not above it is surely below the bound
  std::size_t steps_ = 0;
  std::size_t next_look_ = 512;  ///< at what is surely below it
};

}  // namespace thiessen
