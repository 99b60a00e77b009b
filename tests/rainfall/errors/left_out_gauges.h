#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "basin/shapes.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/errors_of_series.h"
#include "rainfall/normals/doubtful_normals.h"
#include "rainfall/normals/fitted_normals.h"
#include "rainfall/normals/series_normals.h"

namespace thiessen {

/// Gauges with their elevations, and what they read.
struct GaugedSeries {
  Metric metric = Metric::geodesic;
  std::vector<Station> stations;
  std::vector<double> elevations;
  std::vector<std::vector<double>> steps;  ///< by step, then by gauge; NaN where it is silent
};

/// Every tenth gauge left out of a network, or another tenth, and told from the rest: each is a
/// basin so small that it is a point. A gauge reads with an error of its own, the nugget, which
/// basins do not have and which is added to the bars here.
class LeftOutGauges {
 public:
  static constexpr std::size_t folds = 10;

  /// What is told of one gauge at one step, and what it read.
  struct Told {
    double value;
    double error_of_step;     ///< with the gauge's own
    double error_of_normals;  ///< with that of the gauge's own normal
    double reading;

    double standard_error() const { return std::hypot(error_of_step, error_of_normals); }
    bool holds() const { return std::abs(reading - value) <= 1.96 * standard_error(); }
  };

  LeftOutGauges(const GaugedSeries& series, std::size_t fold, bool with_normals) : series_(series) {
    for (std::size_t g = 0; g < series.stations.size(); ++g)
      (g % folds == fold ? left_out_ : kept_).push_back(g);
    for (const std::size_t g : left_out_) {
      const Point p = series.stations[g].position;
      basins_.push_back(shapes::basin(
          {{shapes::rectangle({p.x - half_, p.y - half_}, {p.x + half_, p.y + half_}), {}}}));
    }
    std::vector<Station> stations;
    for (const std::size_t g : kept_) stations.push_back(series.stations[g]);
    network_ = std::make_unique<const Network>(stations, series.metric);
    weighing_ = std::make_unique<Weighing>(*network_, basins_, Yardstick{series.metric, 1, 0.1});
    if (with_normals) take_normals();
    fit();
  }

  const std::vector<std::size_t>& left_out() const { return left_out_; }
  const Weighing& weighing() const { return *weighing_; }
  const RainfallError& error() const { return *error_; }
  const ErrorCorrelation& correlation() const { return *correlation_; }
  double nugget_of_normals() const { return nugget_of_normals_; }
  std::vector<double> kept_readings(std::size_t step) const {
    std::vector<double> readings;
    for (const std::size_t g : kept_) readings.push_back(series_.steps[step][g]);
    return readings;
  }

  /// What is told of each gauge that was left out; nothing where it is silent or no bar is to be
  /// had.
  std::vector<std::optional<Told>> at(std::size_t step) const {
    const std::vector<double> readings = kept_readings(step);
    const std::vector<BasinRainfall> values = error_->at(readings);
    CellAccount account;
    error_->parts().at(readings, account);
    const std::vector<double> squares = error_->mean_squares(account.change);
    std::vector<std::optional<Told>> told(left_out_.size());
    for (std::size_t b = 0; b < told.size(); ++b) {
      const double reading = series_.steps[step][left_out_[b]];
      if (std::isnan(reading) || std::isnan(values[b].standard_error)) continue;
      const double own = std::sqrt(1 + error_->variogram().nugget / squares[b]);
      const double own_normal = values[b].rainfall * std::sqrt(nugget_of_normals_);
      told[b] = {values[b].rainfall, values[b].error_of_step * own,
                 std::hypot(values[b].error_of_normals, own_normal), reading};
    }
    return told;
  }

 private:
  void take_normals() {
    SeriesNormals of_series(kept_.size());
    for (std::size_t t = 0; t < series_.steps.size(); ++t) of_series.add(kept_readings(t));
    std::vector<Point> places;
    std::vector<double> elevations;
    for (const std::size_t g : kept_) {
      places.push_back(series_.stations[g].position);
      elevations.push_back(series_.elevations[g]);
    }
    const FittedNormals fitted(places, elevations, of_series.result(), series_.metric, 1);
    nugget_of_normals_ = fitted.kriging().nugget();
    std::vector<double> gauges;
    for (std::size_t g = 0; g < kept_.size(); ++g) gauges.push_back(fitted.at_place(g));
    std::vector<double> basins;
    std::vector<double> variances;
    for (const std::size_t g : left_out_) {
      const ElevationLine line = fitted.at(series_.stations[g].position);
      const double z = series_.elevations[g];
      basins.push_back(std::exp(line.value(z)));
      variances.push_back(std::max(0.0, line.variance(z)));
    }
    weighing_->take_normals(
        std::make_shared<const DoubtfulNormals>(std::move(gauges), basins, variances));
  }

  void fit() {
    ErrorsOfSeries errors(*weighing_, ErrorsOfSeries::Of::totals);
    for (std::size_t t = 0; t < series_.steps.size(); ++t) errors.add(kept_readings(t), {});
    error_ = errors.of(
        std::make_unique<const ArealRainfall>(*weighing_, ArealRainfallSettings(), 1), {}, 1);
    correlation_ = errors.correlation();
  }

  static constexpr double half_ = 1e-5;  // of a basin, in the unit of coordinates

  const GaugedSeries& series_;
  std::vector<std::size_t> kept_;
  std::vector<std::size_t> left_out_;
  std::vector<Basin> basins_;
  std::unique_ptr<const Network> network_;
  std::unique_ptr<Weighing> weighing_;
  double nugget_of_normals_ = 0;
  std::unique_ptr<const RainfallError> error_;
  std::shared_ptr<const ErrorCorrelation> correlation_;
};

}  // namespace thiessen
