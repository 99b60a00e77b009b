#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "rainfall/gaps/weigher.h"
#include "rainfall/methods/area_method.h"
#include "rainfall/network/reporting.h"

namespace thiessen {

/// Weighs gauges by a method other than Thiessen's cells. Gauges at one place share its weight:
/// those that report, or all of them in the full network's weights.
class MethodWeigher : public Weigher {
 public:
  /// The weighing must outlive this object. `remembered_bytes` bounds the weights that are
  /// remembered.
  MethodWeigher(const Weighing& weighing, std::shared_ptr<const AreaMethod> method,
                std::size_t remembered_bytes);

  const Network& network() const override { return weighing_.network(); }
  const NormalField* normals() const override { return weighing_.normals(); }
  std::vector<BasinWeights> full_weights(const NormalMonth& month) const override;
  std::unique_ptr<const Retessellation> retessellation(const NormalMonth& month) const override;
  using Weigher::full_weights;
  using Weigher::retessellation;

  /// The method's weights when every place reports.
  AreaMethod::Weights full_places(const NormalMonth& month) const;
  /// Divides the weight of each place in equal shares among its stations that report.
  /// `stations_report` has one entry for each station.
  std::vector<BasinWeights> by_station(const AreaMethod::Weights& weights,
                                       const ReportingStations& stations_report,
                                       const NormalMonth& month = {}) const;

 private:
  const Weighing& weighing_;
  std::shared_ptr<const AreaMethod> method_;
  std::size_t remembered_bytes_;
};

}  // namespace thiessen
