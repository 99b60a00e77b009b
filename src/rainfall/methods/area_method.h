#pragma once

#include <vector>

#include "rainfall/reporting.h"
#include "tessellation/place.h"

namespace thiessen {

/// A place's part in a basin, or at a point.
struct PlaceWeight {
  PlaceIndex place;
  double weight;

  friend bool operator==(const PlaceWeight&, const PlaceWeight&) = default;
};

/// A way to weigh gauges in basins: areal rainfall is the sum of weight x reading. Gauges at one
/// place are one, with the mean of those that report.
class AreaMethod {
 public:
  /// By basin, the places that weigh, in their order; the weights are positive and add up to 1. A
  /// basin that the method has no value for has none.
  using Weights = std::vector<std::vector<PlaceWeight>>;

  virtual ~AreaMethod() = default;
  /// The weights where these places report and no others; one entry a place. A function of
  /// `reports` alone. Safe for several threads at once.
  virtual Weights weights(const ReportingPlaces& reports) const = 0;
};

}  // namespace thiessen
