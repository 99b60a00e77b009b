#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "rainfall/gaps/weigher.h"
#include "rainfall/methods/area_method.h"
#include "rainfall/reporting.h"

namespace thiessen {

/// Weighs gauges by a method other than the cells. Gauges at one place share its weight: those that
/// report, or in the full network's weights all of them.
class MethodWeigher : public Weigher {
 public:
  /// The weighing must outlive it. `remembered_bytes`: of weights.
  MethodWeigher(const Weighing& weighing, std::unique_ptr<const AreaMethod> method,
                std::size_t remembered_bytes);

  const Network& network() const override { return weighing_.network(); }
  std::vector<BasinWeights> full_weights() const override;
  std::unique_ptr<const Retessellation> retessellation() const override;

  /// The method's weights where every place reports.
  AreaMethod::Weights full_places() const;
  /// A place's weight in equal shares to its stations that report; one entry a station.
  std::vector<BasinWeights> by_station(const AreaMethod::Weights& weights,
                                       const ReportingStations& stations_report) const;

 private:
  const Weighing& weighing_;
  std::unique_ptr<const AreaMethod> method_;
  std::size_t remembered_bytes_;
};

}  // namespace thiessen
