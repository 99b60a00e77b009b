#pragma once

#include <vector>

#include "base/file.h"
#include "rainfall/weights.h"

namespace thiessen {

/// What the areas of weights are measured in.
struct AreaUnit {
  double km2 = 1e-6;  ///< square kilometres in one; 1 where the plane's unit is unknown: areas are
                      ///< written as they are
};

/// Writes the weights table: CSV `basin,station,area_km2,weight`, the fewest digits that read back
/// to the same double; basins in file order, then stations in file order.
void write_weights(OutputFile& file, const Weighing& weighing,
                   const std::vector<BasinWeights>& weights, AreaUnit unit);

/// The same before and after a change of the network: CSV
/// `basin,station,area_km2,weight,area_km2_after,weight_after`, the stations that weigh in either.
void write_changed_weights(OutputFile& file, const Weighing& weighing,
                           const std::vector<BasinWeights>& before,
                           const std::vector<BasinWeights>& after, AreaUnit unit);

}  // namespace thiessen
