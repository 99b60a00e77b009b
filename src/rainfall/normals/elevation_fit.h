#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "earth/yardstick.h"
#include "rainfall/methods/nearest_gauges.h"
#include "rainfall/normals/fitted_normals.h"

namespace thiessen {

/// What a fit tells at one point of the ground for any elevation there, of one month: ln N as a
/// straight line in elevation, and ln N of the nearest gauge, by which it is held.
struct ToldNormal {
  ElevationLine line;
  double nearest = 0;
};

/// Normals fitted by elevation, for the year or for each calendar month: see FittedNormals, of
/// which it holds one a month. What it tells is held within a quarter and four times the normal of
/// the nearest gauge, for a slope that is told by valleys must not be followed up to any summit.
/// Safe for several threads at once.
class ElevationFit {
 public:
  /// How many times the nearest gauge's normal one may be, and the nearest's it.
  static constexpr double most_factor = 4;

  /// `normals` has those of each place, for the year or month by month; where one is not above 0
  /// the place takes what the others tell. Places that have none in any month change nothing for
  /// the others, so that a network with gauges that never report tells the same. Requires
  /// FittedNormals::least_places places with normals in each month, and the elevations of all.
  ElevationFit(std::span<const Point> places, std::span<const double> elevations,
               std::span<const std::vector<double>> normals, Metric metric, unsigned threads);

  /// 12, or 1 for the year.
  std::size_t months() const { return by_month_.size(); }
  /// The normal at a place: its own where it has one.
  double at_place(std::size_t place, std::size_t month) const {
    return by_month_[month]->at_place(place);
  }
  /// What all other places tell of the normal at this one, held by the nearest other place.
  double without(std::size_t place, std::size_t month) const { return without_[month][place]; }
  /// What is told at a point, month by month.
  void at(Point x, std::span<ToldNormal> by_month) const;

  /// The roots of the mean squares, over all places and months, of the difference between a place's
  /// ln N and what others tell of it: by the fit, by the nearest place, and by the same places as
  /// the fit without their elevations.
  double left_out_error() const { return left_out_error_; }
  double nearest_error() const { return nearest_error_; }
  double level_error() const { return level_error_; }
  /// Whether the fit is so much better than the nearest gauge as FittedNormals wants it.
  bool is_better_than_nearest() const {
    return left_out_error_ < (1 - FittedNormals::least_gain) * nearest_error_;
  }
  /// How far gauges are apart where they lie as they do most often: the side of a square that one
  /// gauge has to itself, by the median distance to the 40th nearest. In the unit of in_space.
  double spacing() const { return spacing_; }
  /// Where the first of the gauges stands that have normals.
  Point first_gauge() const { return at_gauges_.front(); }

 private:
  void find_spacing();
  void tell_without(std::span<const Point> places);

  std::vector<std::size_t> gauges_;  // the places that have normals
  std::vector<Point> at_gauges_;
  NearestGauges nearest_;  // of these
  std::vector<std::unique_ptr<const FittedNormals>> by_month_;
  std::vector<std::vector<double>> without_;  // by month and place
  double left_out_error_ = 0;
  double nearest_error_ = 0;
  double level_error_ = 0;
  double spacing_ = 0;
};

/// ln N at an elevation, held by the nearest gauge's.
double held_logarithm(double logarithm, double of_nearest);

}  // namespace thiessen
