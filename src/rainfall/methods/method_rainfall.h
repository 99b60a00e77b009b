#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "rainfall/methods/area_method.h"
#include "rainfall/methods/method_weigher.h"
#include "rainfall/weighed_rainfall.h"

namespace thiessen {

/// Areal rainfall by a method other than Thiessen's cells. Cost of a step: that of its gap policy
/// (MethodRetessellation, FullNetwork).
class MethodRainfall : public WeighedRainfall {
 public:
  /// The weighing must outlive this object.
  MethodRainfall(const Weighing& weighing, std::unique_ptr<const AreaMethod> method,
                 const ArealRainfallSettings& settings)
      : WeighedRainfall(std::make_shared<const MethodWeigher>(weighing, std::move(method),
                                                              settings.remembered_bytes),
                        settings) {}
};

/// Areal rainfall by several methods at once. Each basin has one value by each method, in the order
/// of the methods.
class SeveralMethods : public StepRainfall {
 public:
  /// Requires at least one method, and the same basins for all.
  explicit SeveralMethods(std::vector<std::unique_ptr<const StepRainfall>> methods)
      : methods_(std::move(methods)) {}

  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override;

 private:
  std::vector<std::unique_ptr<const StepRainfall>> methods_;
};

}  // namespace thiessen
