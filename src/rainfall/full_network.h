#pragma once

#include <cstddef>
#include <span>

#include "rainfall/step_rainfall.h"

namespace thiessen {

/// What a time step with silent gauges gets.
enum class Gaps {
  retessellate,  ///< the tessellation, or whatever else the method is, of the gauges that report
  renormalise,   ///< the full network's weights, scaled to the gauges that report
  strict         ///< no value, where any gauge of positive weight is silent
};

// With the weights that one basin has in the full network, at a time when some gauges are silent.

/// How much of the basin belongs to gauges that report.
double coverage(const BasinWeights& full, std::span<const double> readings);

/// The value; without its coverage. Requires `gaps` other than retessellate.
BasinRainfall rainfall_of_full_network(const BasinWeights& full, std::span<const double> readings,
                                       Gaps gaps, std::size_t min_gauges);
/// The weights of those that report, scaled. Requires `gaps` other than retessellate.
BasinWeights weights_of_full_network(const BasinWeights& full, std::span<const double> readings,
                                     Gaps gaps);

}  // namespace thiessen
