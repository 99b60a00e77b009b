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

/// Finds the most influential gauge of each basin in every `spaced`th step of a sample, at least 1
/// (see spacing_within); of equal ones it takes the first. Where the sample has months, the normals
/// of these count.
SampledInfluence most_influential(const Handovers& handovers, const StepSample& sample,
                                  std::size_t spaced, unsigned threads);

}  // namespace thiessen
