#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/inputs/inputs.h"
#include "cli/options/period_values.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/influence/most_influential.h"
#include "rainfall/normals/normal_field.h"
#include "rainfall/series/largest_depths.h"
#include "rainfall/series/rain_series.h"
#include "rainfall/series/rain_statistics.h"
#include "results/summary_file.h"
#include "study/weight_findings.h"

namespace thiessen::cli {

/// What `run` says in the end: for each basin its area, the gauges inside and weighing, the largest
/// weight, the mean rainfall and its standard error, the largest, the steps without a value, and
/// the gauge whose leaving changes the rainfall most, of a sample of the steps.
class Summary {
 public:
  Summary(const Inputs& inputs, const std::vector<BasinWeights>& weights);
  /// Has the largest depths in these lengths of time looked for. `file` is that of the readings.
  void want_depths(const std::vector<NamedDuration>& lengths, const std::string& file);
  /// `month` is that of the step where months have normals of their own.
  void add(const RainStep& step, const NormalMonth& month = {});
  /// Takes the largest depths, of values in a unit; call it when all steps have been added. Throws
  /// Error where there can be none.
  void find_depths(const std::string& unit);
  /// Takes the standard errors of the means over all steps, by basin, NaN where one cannot be had.
  /// `shortfall` says why none can, or is empty.
  void set_errors_of_mean(std::vector<double> errors, const std::string& shortfall) {
    errors_ = std::move(errors);
    shortfall_ = shortfall;
  }
  /// Looks for the most influential gauge of each basin; call it when all steps have been added.
  void find_most_influential(const ArealRainfall& rainfall, unsigned threads);
  /// What the series comes to, by basin.
  std::vector<BasinSummary> basins() const;
  /// What the weights show.
  const WeightFindings& findings() const { return findings_; }
  /// What a reader of the table should know beside it, in lines; empty where there is nothing.
  std::string remarks() const;
  /// The table of the basins in lines of aligned columns, as wide as fitted() makes them for
  /// `width`, and below it the remarks, broken to that width. Rainfall and errors have as many
  /// decimals as the errors tell them to; all digits are in summary.csv.
  std::string text(const std::string& units, std::size_t width) const;

 private:
  const Inputs& inputs_;
  const std::vector<BasinWeights>& weights_;
  WeightFindings findings_;
  RainStatistics statistics_;
  std::vector<double> errors_;
  std::string shortfall_;
  StepSample sample_;
  std::vector<NamedDuration> lengths_;
  std::optional<LargestDepths> depths_;
  std::vector<std::vector<std::optional<LargestDepth>>> largest_depths_;  ///< by length and basin
  SampledInfluence influence_{{}, 0};
};

}  // namespace thiessen::cli
