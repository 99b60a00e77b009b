#pragma once

#include "results/models/model_weights.h"

namespace thiessen {

/// A meteorologic model of HEC-HMS, a whole .met, whose precipitation is that of weighted gages. A
/// gage's weight is the share of depth and of time alike, so that a subbasin's hyetograph is the
/// sum of weight x reading in each step. Weights have the fewest digits that read back to the same
/// double. Subbasins are called as the basins, gages as the stations.
///
/// Source: US Army Corps of Engineers, HEC-HMS User's Manual, Meteorology Description, "Gage
/// Weights", for what the numbers mean; the keywords are those of .met files that HEC-HMS writes.
class HmsWeights : public ModelWeights {
 public:
  /// Throws Error where a name is empty, begins or ends with a blank or has control characters.
  void write(OutputFile& file, const WeightsSubject& subject, Warnings& warnings) const override;
};

}  // namespace thiessen
