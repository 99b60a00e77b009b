#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "earth/yardstick.h"
#include "rainfall/errors/sites.h"
#include "rainfall/errors/variogram.h"
#include "rainfall/methods/nearest_gauges.h"

namespace thiessen {

/// What kriging tells at one position for any elevation z there: a value that is a straight line in
/// z, and its variance, a parabola.
struct ElevationLine {
  double constant = 0;                        ///< the value at elevation 0
  double slope = 0;                           ///< what a unit of elevation adds
  std::array<double, 3> variance_terms = {};  ///< of 1, z and z squared

  double value(double z) const { return constant + slope * z; }
  double variance(double z) const {
    return variance_terms[0] + z * (variance_terms[1] + z * variance_terms[2]);
  }
};

/// Interpolates values known at places by kriging with an external drift: the value at x and
/// elevation z is a + b z + S(x), where a and b are those of the 40 nearest places and S is a
/// random field with an exponential variogram. A place's value also has an error of its own, the
/// nugget, which the interpolated values are free of.
///
/// The variogram is fitted to the residuals of one straight line in elevation through all values.
/// Such residuals hold what changes over long distances too, which the near places take out: so
/// variances are too large by a factor, which is told by leaving each place out, and divided out.
/// Mountains scatter more about such a plane than plains do: so the factor at x is the mean of what
/// the near places tell and, ten times, of what all tell. The interpolated values do not depend on
/// it.
///
/// Where all near places have one elevation there is no slope. Source: J.-P. Chiles, P. Delfiner,
/// Geostatistics, 2012, section 5.7; the dual form is 3.3.2. Safe for several threads at once.
/// Cost: 12 microseconds a position; the fit 20,000 pairs and a position for each place, and the
/// covariances of all pairs, which up to 1,000 places keep in 4 MB.
class ElevationKriging {
 public:
  static constexpr std::size_t neighbours = 40;

  /// Requires at least three places, all different, with an elevation and a value each.
  ElevationKriging(std::span<const Point> places, std::span<const double> elevations,
                   std::span<const double> values, Metric metric, unsigned threads);

  ElevationLine at(Point x) const;
  /// What all other places tell of this place: its value without the error of its own.
  ElevationLine without(std::size_t place) const;
  /// The value of that at the place's elevation, which is known without computing it again.
  double told_without(std::size_t place) const { return told_[place]; }

  /// The variogram of S, in squares of the values' unit, as it was fitted: before variances are
  /// brought down to what leaving out tells.
  const VariogramModel& variogram() const { return variogram_; }
  /// By what variances are multiplied in the mean, and at x.
  double calibration() const { return calibration_; }
  double calibration_at(Point x) const;
  /// The variance of a place's own error, with the mean calibration.
  double nugget() const { return variogram_.nugget * calibration_; }
  /// The root of the mean square difference between the places' values and what others tell.
  double left_out_error() const { return left_out_error_; }
  /// The same where others tell the value of the nearest place.
  double nearest_error() const { return nearest_error_; }
  /// The same where the others tell it by kriging with this variogram and no elevation. What does
  /// not stay below it owes nothing to elevation, but all to an average of many places.
  double level_error() const { return level_error_; }

 private:
  /// What places tell: with elevation, and a value without.
  struct Told {
    ElevationLine line;
    double level = 0;
  };
  Told told(Direction x, std::span<const NearestGauges::Near> near) const;
  double covariance(Direction a, Direction b) const {
    return variogram_.sill * (1 - variogram_.rise(std::sqrt(square_distance(a, b))));
  }
  void keep_covariances(unsigned threads);
  double covariance_of(std::size_t a, std::size_t b) const;
  std::vector<NearestGauges::Near> others_of(std::size_t place) const;
  double calibration_by(std::span<const NearestGauges::Near> near) const;
  void leave_out(unsigned threads);

  std::vector<Point> places_;
  std::vector<Direction> at_;
  std::vector<double> elevations_;
  std::vector<double> values_;
  Metric metric_;
  NearestGauges nearest_;
  VariogramModel variogram_;
  /// Of places with those before them, place by place; empty where they are too many.
  std::vector<double> covariances_;
  double calibration_ = 1;
  std::vector<double> calibrations_;  // by place: what leaving it out tells
  std::vector<double> told_;          // by place: what all others tell
  double left_out_error_ = 0;
  double nearest_error_ = 0;
  double level_error_ = 0;
};

}  // namespace thiessen
