#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "rainfall/errors/basin_error.h"
#include "rainfall/errors/field_model.h"
#include "rainfall/errors/field_parts.h"
#include "rainfall/network/weights.h"
#include "rainfall/series/step_sample.h"

namespace thiessen {

/// What RainfallError fits to a series, and what it computes for each basin once. It is remembered
/// for other methods and months of the same series.
struct FittedErrors {
  std::shared_ptr<const FieldModel> model;
  std::vector<std::shared_ptr<const BasinError>> basins;  ///< none where there is a shortfall
};

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
/// With normals the field is that of readings divided by their gauges' normals, and a basin's mean
/// normal N has an error of its own, of the variance s^2 of its logarithm (0 where normals are
/// given). The square of the error is N^2 x the field's variance x the mean square for the gauges'
/// parts (FieldParts), widened, and (value x s)^2. Where a method scales weights so that the parts
/// add up to p and not to 1, value x (1 - 1 / p) is an error, too.
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
  /// Fits the model to a sample of the series, which has a column for each station and, where there
  /// are normals, readings relative to those of each step's month (relative_readings). The rainfall
  /// is by the year's normals; both must outlive this object.
  RainfallError(const WeighedRainfall& rainfall, const Weighing& weighing, const StepSample& sample,
                unsigned threads);
  /// The same for what a method, a calendar month's normals or both make of the rainfall.
  RainfallError(std::shared_ptr<const WeighedRainfall> rainfall, const NormalMonth& month,
                const Weighing& weighing, const StepSample& sample, unsigned threads);
  /// The same for another method or month by what was fitted for one.
  RainfallError(const FittedErrors& like, std::shared_ptr<const WeighedRainfall> rainfall,
                const NormalMonth& month, unsigned threads);
  RainfallError(const RainfallError&) = delete;
  RainfallError& operator=(const RainfallError&) = delete;

  /// Says why there are no figures at all, as in "4 time steps ...: 10 are needed"; empty where
  /// there are some.
  const std::string& shortfall() const { return fitted_.model->shortfall(); }
  /// The fitted variogram. Requires that there is no shortfall.
  const VariogramModel& variogram() const { return model().variogram().model(); }

  /// The values of the rainfall with their standard errors, in the readings' unit. Safe for
  /// several threads at once.
  std::vector<BasinRainfall> at(std::span<const double> readings) const override;
  std::vector<BasinWeights> weights_at(std::span<const double> readings) const override {
    return parts_.rainfall().weights_at(readings);
  }

  /// The mean square of the error by basin, in units of the field's variance, where parts change by
  /// `change` (as in the account of FieldParts). Requires that there is no shortfall.
  std::vector<double> mean_squares(const std::vector<CellWeight>& change) const;
  const FieldParts& parts() const { return parts_; }
  const FieldModel& model() const { return *fitted_.model; }
  const FittedErrors& fitted() const { return fitted_; }

 private:
  void weigh(const std::vector<std::shared_ptr<const BasinError>>& like, unsigned threads);
  std::shared_ptr<const BasinError> basin_error(std::size_t basin, std::span<const SiteWeight> full,
                                                const BasinError* like) const;
  void take_normals(std::size_t b, std::span<const SiteWeight> change, BasinRainfall& basin) const;

  FieldParts parts_;
  FittedErrors fitted_;
};

/// How many steps the sample of a series should hold that RainfallError is fitted to.
std::size_t steps_for_errors(std::size_t stations);

}  // namespace thiessen
