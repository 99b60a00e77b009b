#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/basin_error.h"
#include "rainfall/errors/step_variance.h"
#include "rainfall/network/weights.h"
#include "rainfall/series/step_sample.h"

namespace thiessen {

/// The standard error of areal rainfall: how far a sum of weight x reading may be from the mean
/// rain over the basin, as far as the gauges themselves can tell.
///
/// The readings of one step are taken as those of a random field whose mean and variance are the
/// same everywhere, and whose correlation depends on distance alone and is the same at all steps.
/// This is the climatological variogram (T. Lebel, G. Bastin, C. Obled, J. D. Creutin, On the
/// accuracy of areal rainfall estimation, Water Resources Research 23, 1987). The variogram is
/// fitted once, to a sample of the series (distance_classes.h, variogram_fit.h); the variance is
/// estimated at each step (StepVariance). Together they give the mean square of the error for the
/// step's weights (BasinError). Its root is widened by the ratio of Student's quantile to the
/// normal one, so that 1.96 standard errors to each side are a 95 % bar although only a few gauges
/// tell the variance.
///
/// The model cannot bound what it does not know: a mean that changes between near gauges (hills),
/// gauges that all err to one side (wind), and steps at which it rains in one part of the network
/// only, which give dry basins the step's variance too. The stations of one place count as one
/// gauge with their mean reading and one nugget.
///
/// There is no figure where fewer than five gauges report, and none where all that report read the
/// same (a dry day): their agreement does not tell how far they are off. The result depends neither
/// on threads nor on the order of the stations.
///
/// Cost, once: the sample's pairs (20,000 at most) times its steps, and for each basin its weights
/// and its points (8 a weight, but 256 to 4,096) times its points. Cost of a step: its gauges, and
/// for each basin the square of the number of gauges whose weight changed. Memory: the sample
/// twice, 24 bytes a point, and 200 bytes a gauge.
class RainfallError : public StepRainfall {
 public:
  /// Fits the model to a sample of the series, which has a column for each station. The rainfall
  /// must outlive this object.
  RainfallError(const ArealRainfall& rainfall, const Weighing& weighing, const StepSample& sample,
                unsigned threads);
  RainfallError(const RainfallError&) = delete;
  RainfallError& operator=(const RainfallError&) = delete;

  /// Says why there are no figures at all, as in "4 time steps ...: 10 are needed"; empty where
  /// there are some.
  const std::string& shortfall() const { return shortfall_; }
  /// The fitted variogram. Requires that there is no shortfall.
  const VariogramModel& variogram() const { return variogram_->model(); }

  /// The values of ArealRainfall::at with their standard errors, in the readings' unit. Safe for
  /// several threads at once.
  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override {
    return rainfall_.weights_at(readings);
  }

  /// The mean square of the error by basin, in units of the field's variance, where weights change
  /// by `change` (as in CellAccount). Requires that there is no shortfall.
  std::vector<double> mean_squares(const std::vector<CellWeight>& change) const;
  const StepVariance& variance() const { return *variance_; }
  const Sites& sites() const { return sites_; }

 private:
  StepSample by_site(const StepSample& sample) const;
  std::vector<double> by_site(const std::vector<double>& of_cell) const;
  void weigh(const Weighing& weighing, unsigned threads);

  const ArealRainfall& rainfall_;
  Sites sites_;
  std::string shortfall_;
  std::optional<Variogram> variogram_;
  std::optional<StepVariance> variance_;
  std::vector<std::unique_ptr<const BasinError>> basins_;
};

/// How many steps the sample of a series should hold that RainfallError is fitted to.
std::size_t steps_for_errors(std::size_t stations);

}  // namespace thiessen
