#pragma once

#include <span>
#include <string>
#include <vector>

#include "rainfall/errors/sites.h"
#include "rainfall/series/step_sample.h"

namespace thiessen {

/// A class of pairs of gauges that are about equally far apart.
struct DistanceClass {
  double distance;      ///< their mean distance
  double semivariance;  ///< half the mean square difference of standardised readings
  double pairs;         ///< their number
};

/// The empirical variogram of a sample of a series, or why there is none.
struct DistanceClasses {
  std::vector<DistanceClass> classes;  ///< the nearest pairs first
  std::string shortfall;  ///< why there are none, as in "4 time steps ...: 10 are needed"
};

/// The least numbers of gauges and of steps to which a variogram can be fitted.
inline constexpr std::size_t least_gauges = 5;
inline constexpr std::size_t least_steps = 10;

/// Sorts pairs of gauges into classes by distance and measures how their readings differ.
///
/// Each gauge's readings are standardised by their own mean and standard deviation over the steps
/// at which it reports, so that what lasts (a wetter hill) is not a difference. Then half the mean
/// square difference of two gauges, over the steps at which both report (`least_steps` at least),
/// is 1 less their correlation. There are four classes to each doubling of the distance.
///
/// `sample` has a column for each site. Where there are at most 20,000 pairs (200 gauges) every
/// pair counts. Else the pairs are those 1, 2, 3, 4, 6, 8, 12 ... gauges apart in the order of the
/// sites, 20,000 at most: so all distances occur, and near ones more often. Cost: 1 nanosecond for
/// each pair and step of the sample.
DistanceClasses distance_classes(const StepSample& sample, const Sites& sites, unsigned threads);

/// The same for one value a site: the semivariance of a class is half the mean square difference of
/// the values, in the square of their unit. Empty where there are fewer than two sites.
std::vector<DistanceClass> distance_classes(std::span<const double> values, const Sites& sites);

}  // namespace thiessen
