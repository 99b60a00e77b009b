#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "rainfall/network/weights.h"
#include "results/provenance.h"

namespace thiessen {

/// The weights of a network in basins, as a file of a model has them.
struct WeightsSubject {
  const Weighing& weighing;
  const std::vector<BasinWeights>& weights;
  Provenance made_by;
};

/// A format in which a model reads weights.
class ModelWeights {
 public:
  virtual ~ModelWeights() = default;
  /// Throws Error where the format cannot hold the ids.
  virtual void write(OutputFile& file, const WeightsSubject& subject, Warnings& warnings) const = 0;
};

}  // namespace thiessen
