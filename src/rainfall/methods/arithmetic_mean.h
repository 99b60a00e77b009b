#pragma once

#include "rainfall/methods/area_method.h"
#include "rainfall/network/weights.h"

namespace thiessen {

/// The mean of the gauges inside a basin or on its edge. A basin without such a gauge has no value.
/// With normals it is the mean of the readings, each relative to its gauge's normal, times the
/// basin's.
class ArithmeticMean : public AreaMethod {
 public:
  static constexpr const char* name = "arithmetic";

  /// Finds the places in each basin. The weighing must outlive this object. Cost: that of
  /// Containment for each place in a basin's box.
  explicit ArithmeticMean(const Weighing& weighing);
  Weights weights(const ReportingPlaces& reports, const NormalMonth& month) const override;
  using AreaMethod::weights;

 private:
  const Weighing& weighing_;
  std::vector<std::vector<std::size_t>> inside_;  // by basin: its places in rising order
};

}  // namespace thiessen
