#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "rainfall/network/weights.h"
#include "rainfall/weighed_rainfall.h"

namespace thiessen {

/// What values are made of in terms of the field whose errors are told.
///
/// Without normals the field is that of the readings r, and a gauge's part is its weight. With
/// normals it is that of q = r / N_i, which hills do not lift: a value is N times the sum of v_i
/// q_i, where N is the basin's mean normal and v_i = weight x factor x N_i / N. These parts add up
/// to 1, as weights do. N is taken from the weights when every gauge reports, for so ground without
/// normals counts in it as in the values. All normals are relative to that of the first station.
///
/// Safe for several threads at once. Cost of a step with normals: that of its weights.
class FieldParts {
 public:
  /// The rainfall is that of the month, or by the year's normals. The weighing must outlive this.
  FieldParts(std::shared_ptr<const WeighedRainfall> rainfall, const Weighing& weighing,
             const NormalMonth& month);

  const WeighedRainfall& rainfall() const { return *rainfall_; }
  /// The parts when every gauge reports, by basin, then by cell.
  std::vector<CellWeight> full() const;
  /// The values of a step, and the account of them: readings by cell and changes of the parts are
  /// those of the field. Of methods that are scaled the parts may come to add up to other than 1.
  std::vector<BasinRainfall> at(std::span<const double> readings, CellAccount& account) const;

  bool has_normals() const { return normals_ != nullptr; }
  /// The basin's mean normal; 1 without normals.
  double normal(std::size_t basin) const { return has_normals() ? basin_normals_[basin] : 1; }
  /// The standard error of that normal as a share of it.
  double error_of_normal(std::size_t basin) const {
    return has_normals() ? errors_of_normals_[basin] : 0;
  }

 private:
  std::vector<CellWeight> parts_of(const std::vector<BasinWeights>& weights) const;
  std::vector<CellWeight> change(std::span<const double> readings) const;

  std::shared_ptr<const WeighedRainfall> rainfall_;
  const Network& network_;
  const NormalField* normals_;
  std::vector<double> at_gauges_;          // by station: its normal
  std::vector<double> basin_normals_;      // by basin
  std::vector<double> errors_of_normals_;  // by basin
  std::vector<CellWeight> full_;           // with normals: the parts when every gauge reports
};

/// The variance of the logarithm of a basin's mean normal in a month or the year.
double log_variance(const NormalField& normals, std::size_t basin, const NormalMonth& month);

}  // namespace thiessen
