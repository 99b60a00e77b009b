#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "earth/yardstick.h"
#include "rainfall/normals/elevation_kriging.h"

namespace thiessen {

/// Normals between gauges, fitted to those of the gauges by elevation: their logarithm is
/// interpolated by ElevationKriging. Logarithms, because a mountain multiplies rain. Safe for
/// several threads at once.
class FittedNormals {
 public:
  /// The least number of places with a normal and an elevation to which a fit is made.
  static constexpr std::size_t least_places = 10;
  /// By how much leaving each gauge out has to lessen the error of ln N against the nearest
  /// gauge's.
  static constexpr double least_gain = 0.1;

  /// `normals` has one entry for each place. Where it is not above 0 (no rain, no reading) a place
  /// takes what the others tell of it. Requires `least_places` places with a normal and, for all
  /// places, elevations.
  FittedNormals(std::span<const Point> places, std::span<const double> elevations,
                std::span<const double> normals, Metric metric, unsigned threads);

  /// The normal at a place: its own where it has one.
  double at_place(std::size_t place) const { return at_place_[place]; }
  /// What all other places tell of the normal at this one.
  double without(std::size_t place) const;
  /// The straight line in elevation that ln N is at x; its variance is that of ln N.
  ElevationLine at(Point x) const { return kriging_.at(x); }

  const ElevationKriging& kriging() const { return kriging_; }
  /// Whether the fit tells a gauge that was left out so much better than the nearest gauge does.
  bool is_better_than_nearest() const {
    return kriging_.left_out_error() < (1 - least_gain) * kriging_.nearest_error();
  }

 private:
  /// The places that have a normal, as kriging wants them.
  struct Known {
    std::vector<Point> places;
    std::vector<double> elevations;
    std::vector<double> logarithms;
    std::vector<std::optional<std::size_t>> number;  ///< by place: its number among these
  };
  static Known known(std::span<const Point> places, std::span<const double> elevations,
                     std::span<const double> normals);
  FittedNormals(Known known, std::span<const Point> places, std::span<const double> elevations,
                Metric metric, unsigned threads);

  std::vector<std::optional<std::size_t>> number_;
  ElevationKriging kriging_;
  std::vector<double> at_place_;
};

}  // namespace thiessen
