#pragma once

#include <memory>

#include "rainfall/gaps/cell_weigher.h"
#include "rainfall/network/weights.h"
#include "rainfall/weighed_rainfall.h"

namespace thiessen {

/// Areal rainfall by Thiessen's cells. The weighing must outlive this object. Safe for several
/// threads at once. The result depends on the readings alone, not on what is remembered from
/// earlier steps. Cost of a step: that of its gap policy (CellRetessellation, FullNetwork).
class ArealRainfall : public WeighedRainfall {
 public:
  /// The name of this method among those of src/rainfall/methods.
  static constexpr const char* name = "thiessen";

  /// The normals that count, if there are any, are those of the year.
  ArealRainfall(const Weighing& weighing, const ArealRainfallSettings& settings, unsigned threads);
  /// The same for the steps of a calendar month, or by the year's normals, of the same gauges and
  /// with the same memory.
  std::unique_ptr<const ArealRainfall> of_month(const NormalMonth& month) const {
    return std::unique_ptr<const ArealRainfall>(new ArealRainfall(cells_, settings(), month));
  }

  /// What silent gauges hand over. These are the handovers that retessellation uses; where another
  /// policy uses none they are made when they are first asked for.
  const Handovers& handovers() const { return cells_->handovers(); }

 private:
  ArealRainfall(std::shared_ptr<const CellWeigher> cells, const ArealRainfallSettings& settings,
                const NormalMonth& month);

  std::shared_ptr<const CellWeigher> cells_;
};

}  // namespace thiessen
