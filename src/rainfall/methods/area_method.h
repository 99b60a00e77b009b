#pragma once

#include <vector>

#include "rainfall/network/reporting.h"
#include "rainfall/normals/normal_field.h"
#include "tessellation/place.h"

namespace thiessen {

/// The weight of a place in a basin, or at a point.
struct PlaceWeight {
  PlaceIndex place;
  double weight;
  /// The mean normal of where the place weighs, each point as much as the place does there,
  /// relative to that of the first station; 1 without normals.
  double normal = 1;

  friend bool operator==(const PlaceWeight&, const PlaceWeight&) = default;
};

/// A way to weigh gauges in basins; areal rainfall is then the sum of weight x factor x
/// reading. Gauges at
/// one place count as one, with the mean reading of those that report.
class AreaMethod {
 public:
  /// The places that weigh in each basin, in rising order. The weights are positive and add up to
  /// 1. A basin for which the method has no value has no weights.
  using Weights = std::vector<std::vector<PlaceWeight>>;

  virtual ~AreaMethod() = default;
  /// The weights when exactly these places report, with the normals of a month or of the year.
  /// `reports` has one entry for each place, and the result depends on it and the month alone. Safe
  /// for several threads at once.
  virtual Weights weights(const ReportingPlaces& reports, const NormalMonth& month) const = 0;
  Weights weights(const ReportingPlaces& reports) const { return weights(reports, {}); }
};

}  // namespace thiessen
