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
  /// The weighing must outlive this object. The normals that count are those of a month, or of the
  /// year.
  MethodRainfall(const Weighing& weighing, std::shared_ptr<const AreaMethod> method,
                 const ArealRainfallSettings& settings, const NormalMonth& month = {})
      : WeighedRainfall(std::make_shared<const MethodWeigher>(weighing, std::move(method),
                                                              settings.remembered_bytes),
                        settings, month) {}
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

/// Areal rainfall by normals that calendar months have of their own: that of each month in turn.
class MonthlyRainfall : public StepRainfall {
 public:
  /// `months` has one for each calendar month, and `year` is for what has none.
  MonthlyRainfall(std::vector<std::unique_ptr<const StepRainfall>> months,
                  std::unique_ptr<const StepRainfall> year)
      : months_(std::move(months)), year_(std::move(year)) {}

  std::vector<BasinRainfall> at(std::span<const double> readings) const override {
    return year_->at(readings);
  }
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override {
    return year_->weights_at(readings);
  }
  bool tells_months() const override { return true; }
  const StepRainfall& in_month(std::size_t month) const override { return *months_[month]; }

 private:
  std::vector<std::unique_ptr<const StepRainfall>> months_;
  std::unique_ptr<const StepRainfall> year_;
};

}  // namespace thiessen
