#pragma once

#include <cstddef>
#include <vector>

#include "rainfall/gaps/handover.h"
#include "rainfall/series/step_sample.h"

namespace thiessen {

/// The gauge of a basin that changes its rainfall most when it is left out.
struct MostInfluential {
  StationIndex station;
  double rms_change;  ///< see GaugeInfluence; 0: no gauge is known to change anything
};

struct SampledInfluence {
  std::vector<MostInfluential> gauges;  ///< by basin
  std::size_t steps;                    ///< number that were looked at
};

/// Finds the most influential gauge of each basin in a sample of steps; of equal ones it takes the
/// first.
///
/// It looks at all steps of the sample or, where they have too many gaps, at every second, third
/// and so on, so that about `most_handovers` handovers of several cells are computed, beside one
/// for each cell that has ground.
SampledInfluence most_influential(const Handovers& handovers, const StepSample& sample,
                                  std::size_t most_handovers, unsigned threads);

}  // namespace thiessen
