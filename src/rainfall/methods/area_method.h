#pragma once

#include <vector>

#include "rainfall/network/reporting.h"
#include "tessellation/place.h"

namespace thiessen {

/// The weight of a place in a basin, or at a point.
struct PlaceWeight {
  PlaceIndex place;
  double weight;

  friend bool operator==(const PlaceWeight&, const PlaceWeight&) = default;
};

/// A way to weigh gauges in basins; areal rainfall is then the sum of weight x reading. Gauges at
/// one place count as one, with the mean reading of those that report.
class AreaMethod {
 public:
  /// The places that weigh in each basin, in rising order. The weights are positive and add up to
  /// 1. A basin for which the method has no value has no weights.
  using Weights = std::vector<std::vector<PlaceWeight>>;

  virtual ~AreaMethod() = default;
  /// The weights when exactly these places report. `reports` has one entry for each place, and the
  /// result depends on it alone. Safe for several threads at once.
  virtual Weights weights(const ReportingPlaces& reports) const = 0;
};

}  // namespace thiessen
