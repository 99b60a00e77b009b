#pragma once

#include <memory>
#include <span>
#include <vector>

#include "rainfall/areal_rainfall.h"
#include "rainfall/methods/area_method.h"
#include "rainfall/methods/weights_cache.h"

namespace thiessen {

/// Areal rainfall by a method other than the cells'. What a step with silent gauges gets is said as
/// of the cells: the method anew among those that report (retessellate), its full network's weights
/// scaled to them, or no value where one that weighs in the full network is silent. Gauges at one
/// place share its weight: those that report, or in the full network's weights all of them. Cost of
/// a step: its gauges and the weights; and what the method takes for a set of reporting gauges that
/// is not remembered.
class MethodRainfall : public StepRainfall {
 public:
  /// The weighing must outlive it.
  MethodRainfall(const Weighing& weighing, std::unique_ptr<const AreaMethod> method,
                 const ArealRainfallSettings& settings);

  /// By basin.
  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override;

 private:
  std::vector<bool> reports(std::span<const double> readings) const;
  std::vector<BasinRainfall> of_reporting(std::span<const double> readings) const;
  std::vector<BasinWeights> by_station(const AreaMethod::Weights& weights,
                                       const std::vector<bool>& reports) const;

  const Weighing& weighing_;
  std::unique_ptr<const AreaMethod> method_;
  ArealRainfallSettings settings_;
  mutable WeightsCache remembered_;
  std::vector<BasinWeights> full_;
};

/// Several methods at once: for each basin its value by each of them, in their order.
class SeveralMethods : public StepRainfall {
 public:
  /// Requires at least one, all of the same basins.
  explicit SeveralMethods(std::vector<std::unique_ptr<const StepRainfall>> methods)
      : methods_(std::move(methods)) {}

  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override;

 private:
  std::vector<std::unique_ptr<const StepRainfall>> methods_;
};

}  // namespace thiessen
