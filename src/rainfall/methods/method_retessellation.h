#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rainfall/gaps/retessellation.h"
#include "rainfall/methods/area_method.h"
#include "rainfall/methods/method_weigher.h"
#include "rainfall/methods/weights_cache.h"

namespace thiessen {

/// Retessellation for a method other than Thiessen's cells: the method is applied anew to the
/// gauges that report. The cells of its accounts are the network's places. Cost of a step: its
/// gauges and the weights; and the method's own cost for each set of reporting gauges that is not
/// remembered.
class MethodRetessellation : public Retessellation {
 public:
  /// The weigher and the method must outlive this object.
  MethodRetessellation(const MethodWeigher& weigher, const AreaMethod& method,
                       const NormalMonth& month, std::size_t remembered_bytes);

  const std::vector<BasinWeights>& full_weights() const override { return full_; }
  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinRainfall> at(std::span<const double> readings,
                                CellAccount& account) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override;
  std::vector<CellWeight> full_cells() const override;
  std::vector<double> cell_readings(std::span<const double> readings) const override;

 private:
  using StepWeights = std::shared_ptr<const AreaMethod::Weights>;

  /// The weights of the places that report, remembered or computed.
  StepWeights weights_of(std::span<const double> readings) const;
  std::vector<BasinRainfall> rainfall(const AreaMethod::Weights& weights,
                                      std::span<const double> readings) const;

  const MethodWeigher& weigher_;
  NormalMonth month_;
  std::vector<double> at_gauges_;  // the normals by station; 1 without
  AreaMethod::Weights full_places_;
  std::vector<BasinWeights> full_;
  mutable WeightsCache remembered_;
};

}  // namespace thiessen
