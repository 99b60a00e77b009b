#pragma once

#include <cstddef>
#include <vector>

#include "rainfall/gaps/handover.h"
#include "rainfall/series/step_sample.h"

namespace thiessen {

/// The gauge whose leaving changes a basin's rainfall most.
struct MostInfluential {
  StationIndex station;
  double rms_change;  ///< see GaugeInfluence; 0: no gauge's leaving is known to change anything
};

struct SampledInfluence {
  std::vector<MostInfluential> gauges;  ///< by basin
  std::size_t steps;                    ///< that were looked at
};

/// Looks at all steps of a sample, or, where their gaps are too many, at every second, third and so
/// on of them, so that about `most_handovers` handovers of several cells are computed, beyond one
/// for each cell that has ground. Of equally influential gauges it takes the first.
SampledInfluence most_influential(const Handovers& handovers, const StepSample& sample,
                                  std::size_t most_handovers, unsigned threads);

}  // namespace thiessen
