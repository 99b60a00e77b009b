#pragma once

#include <memory>

#include "rainfall/gaps/cell_weigher.h"
#include "rainfall/weighed_rainfall.h"
#include "rainfall/weights.h"

namespace thiessen {

/// Areal rainfall by Thiessen's cells. The weighing must outlive it. Safe for several threads at
/// once. What it gives depends on the readings alone, not on what it remembers. Cost of a step: its
/// gap policy's (CellRetessellation, FullNetwork).
class ArealRainfall : public WeighedRainfall {
 public:
  /// Of the method, among those of src/rainfall/methods.
  static constexpr const char* name = "thiessen";

  ArealRainfall(const Weighing& weighing, const ArealRainfallSettings& settings, unsigned threads);

  /// What silent gauges hand over: those that it retessellates with, or made when they are first
  /// asked for.
  const Handovers& handovers() const { return cells_->handovers(); }

 private:
  ArealRainfall(std::shared_ptr<const CellWeigher> cells, const ArealRainfallSettings& settings);

  std::shared_ptr<const CellWeigher> cells_;
};

}  // namespace thiessen
