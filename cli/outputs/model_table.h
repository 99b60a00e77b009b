#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/outputs/rain_output.h"
#include "rainfall/series/rain_totals.h"
#include "results/models/model_series.h"

namespace thiessen::cli {

/// Hands a series on to a model's format: the steps, or their totals over periods.
class ModelTable : public RainOutput {
 public:
  /// `format` is what `--format` says and `rainfall` the file of the readings, for messages.
  ModelTable(std::unique_ptr<ModelSeries> series, std::string format,
             const std::optional<Totalling>& totalling, std::string rainfall);
  ModelTable(const ModelTable&) = delete;
  ModelTable& operator=(const ModelTable&) = delete;

  void prepare(RainStep& /*step*/) const override {}
  void add(const RainStep& step, std::size_t pattern) override;
  void finish(Warnings& warnings) override;

 private:
  void add(const RainPeriod& period);

  std::unique_ptr<ModelSeries> series_;
  std::string format_;
  std::string rainfall_;
  bool totals_have_errors_;
  std::unique_ptr<RainTotals> periods_;
  std::vector<double> values_;
  std::vector<double> errors_;
  std::size_t incomplete_ = 0;  ///< totals that lack steps
};

}  // namespace thiessen::cli
