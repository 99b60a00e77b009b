#pragma once

#include <vector>

#include "base/file.h"
#include "rainfall/influence/influence.h"
#include "rainfall/network/weights.h"

namespace thiessen {

/// Writes how much each gauge matters to each basin: CSV
/// `basin,station,weight,rms_change,mean_change`, in the fewest digits that read back to the same
/// double; basins in file order, then stations in file order. The changes are empty where no step
/// has a value without the gauge.
void write_influence(OutputFile& file, const Weighing& weighing,
                     const std::vector<std::vector<GaugeInfluence>>& influence);

}  // namespace thiessen
