#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/destination.h"
#include "base/outputs.h"
#include "cli/inputs/inputs.h"
#include "cli/options/blocks/model_options.h"
#include "results/models/model_series.h"
#include "results/models/model_weights.h"

namespace thiessen::cli {

/// The files that a model's format is written to.
class ModelFiles {
 public:
  /// Opens what can be opened before anything is read. The outputs must outlive it. Throws Error
  /// where the output may not be written.
  ModelFiles(RainModel model, const std::string& path, Outputs& outputs, const OutputRules& rules);

  /// The series in its format, without a step yet. Throws Error where the format cannot hold the
  /// basins or the unit, or a file that it needs may not be written.
  std::unique_ptr<ModelSeries> series(const Inputs& inputs, ModelSubject subject, bool has_errors);

 private:
  std::unique_ptr<ModelSeries> swat_series(ModelSubject subject);

  RainModel model_;
  std::string path_;
  Outputs& outputs_;
  const OutputRules& rules_;
  OutputFile* file_ = nullptr;
  std::string foreign_;  ///< where a library writes the file
};

/// The format in which weights are written.
std::unique_ptr<const ModelWeights> weights_format(WeightsModel model);

}  // namespace thiessen::cli
