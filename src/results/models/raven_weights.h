#pragma once

#include "results/models/model_weights.h"

namespace thiessen {

/// Raven's table of gauge weights, which `:Interpolation INTERP_FROM_FILE` reads: the numbers of
/// gauges and of hydrologic response units, then a row a unit with the weight of every gauge, 0
/// too. Units are the basins in the order of their file, gauges the stations of the network in
/// theirs: so have they to stand in the .rvh and the .rvt. Weights have the fewest digits that read
/// back to the same double; comments name the gauges and the units.
///
/// Source: the Raven development team, Raven: User's and Developer's Manual v2.8, the command
/// :Interpolation and its file, :GaugeWeightTable.
class RavenWeights : public ModelWeights {
 public:
  void write(OutputFile& file, const WeightsSubject& subject, Warnings& warnings) const override;
};

}  // namespace thiessen
