#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "rainfall/network/network.h"
#include "rainfall/normals/elevation_fit.h"
#include "rainfall/normals/normal_field.h"

namespace thiessen {

/// The normals over one basin that a fit tells: those of its ground, with their variance.
class FittedBasinNormals : public BasinNormals {
 public:
  /// `log_variances` has one entry a month. `ground` must outlive it.
  FittedBasinNormals(const BasinNormals& ground, std::vector<double> log_variances)
      : ground_(ground), log_variances_(std::move(log_variances)) {}

  bool is_uniform() const override { return ground_.is_uniform(); }
  const GroundMeasure* measure() const override { return ground_.measure(); }
  std::unique_ptr<const GroundMeasure> measure_in(const GnomonicChart& chart) const override {
    return ground_.measure_in(chart);
  }
  GroundNormal of(std::span<const double> figures, double area, std::size_t month) const override {
    return ground_.of(figures, area, month);
  }
  GroundNormal whole(std::size_t month) const override { return ground_.whole(month); }
  double at(Point p, std::size_t month) const override { return ground_.at(p, month); }
  double log_variance(std::size_t month) const override { return log_variances_[month]; }

 private:
  const BasinNormals& ground_;
  std::vector<double> log_variances_;
};

/// Normals that were fitted to gauges by elevation: over the ground those of a field that was made
/// of the fit, at a gauge its own, and without the gauge what the others tell.
class ElevationNormals : public NormalField {
 public:
  /// `ground` has the normals at the gauges and over the basins, and `log_variances` those of the
  /// basins' means, month by month. The network must outlive it.
  ElevationNormals(std::shared_ptr<const ElevationFit> fit, const Network& network,
                   std::shared_ptr<const NormalField> ground,
                   std::span<const std::vector<double>> log_variances);

  std::size_t months() const override { return ground_->months(); }
  double at_gauge(StationIndex station, std::size_t month) const override {
    return ground_->at_gauge(station, month);
  }
  double without(StationIndex station, std::size_t month) const override {
    return fit_->without(index(network_.place_of(station)), month);
  }
  const BasinNormals& in(std::size_t basin) const override { return basins_[basin]; }

 private:
  std::shared_ptr<const ElevationFit> fit_;
  const Network& network_;
  std::shared_ptr<const NormalField> ground_;
  std::vector<FittedBasinNormals> basins_;
};

/// The fit's normals at the stations of a network, month by month.
std::vector<std::vector<double>> normals_at_stations(const ElevationFit& fit,
                                                     const Network& network);

}  // namespace thiessen
