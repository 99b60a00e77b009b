#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/basin_error.h"
#include "rainfall/errors/step_variance.h"
#include "rainfall/series/step_sample.h"
#include "rainfall/weights.h"

namespace thiessen {

/// The standard error of areal rainfall: how far sums of weight x reading may be off the mean of
/// the rain over the basin, by what the gauges themselves tell.
///
/// Readings of one step are taken for those of a field whose mean and variance are the same
/// everywhere, and whose correlation is a function of distance alone, the same at all steps (the
/// climatological variogram of T. Lebel, G. Bastin, C. Obled, J. D. Creutin, On the accuracy of
/// areal rainfall estimation, Water Resources Research 23, 1987). That function is fitted once, to
/// a sample of the series (distance_classes.h, variogram_fit.h); the variance is the step's own
/// (StepVariance); the two give the mean square of the error for the step's weights (BasinError).
/// Its root is widened by Student's quantile over the normal one, so that 1.96 standard errors to
/// each side are a 95 % bar though a few gauges tell the variance.
///
/// What the model does not know it does not bound: a mean that changes within the network between
/// near gauges (hills), gauges that all err to one side (wind), and steps at which it rains here
/// and not there: these have the step's variance at dry basins too. Stations of one place count as
/// one gauge of their mean reading, with one nugget.
///
/// No figure below five gauges that report, and none where all that do read the same (a dry day):
/// that they agree does not tell how far they are off. What comes out depends neither on threads
/// nor on the order of the stations.
///
/// Cost, once: the sample's pairs (20,000 at most) times its steps; for each basin its weights and
/// its points (8 a weight, 256 to 4,096) times its points. Of a step: its gauges, and for each
/// basin the square of the number of gauges whose weight changed. Memory: the sample twice; 24
/// bytes a point; 200 bytes a gauge.
class RainfallError : public StepRainfall {
 public:
  /// A sample of the series: a column a station. The rainfall must outlive this.
  RainfallError(const ArealRainfall& rainfall, const Weighing& weighing, const StepSample& sample,
                unsigned threads);
  RainfallError(const RainfallError&) = delete;
  RainfallError& operator=(const RainfallError&) = delete;

  /// Why there are no figures at all, as in "4 time steps ...: 10 are needed"; empty where there
  /// are.
  const std::string& shortfall() const { return shortfall_; }
  /// Requires no shortfall.
  const VariogramModel& variogram() const { return variogram_->model(); }

  /// What ArealRainfall::at gives, with the standard errors, in the readings' unit. Safe for
  /// several threads at once.
  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override {
    return rainfall_.weights_at(readings);
  }

  /// Of its parts, by basin: the mean square of the error in units of the field's variance, where
  /// weights change as in CellAccount. Requires no shortfall.
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

/// How many steps a sample of a series for RainfallError holds.
std::size_t steps_for_errors(std::size_t stations);

}  // namespace thiessen
