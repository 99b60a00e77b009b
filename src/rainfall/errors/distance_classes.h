#pragma once

#include <string>
#include <vector>

#include "rainfall/errors/sites.h"
#include "rainfall/series/step_sample.h"

namespace thiessen {

/// Pairs of gauges about as far apart.
struct DistanceClass {
  double distance;      ///< their mean
  double semivariance;  ///< half the mean square difference of their readings, standardised
  double pairs;         ///< how many
};

/// What a sample of a series tells of how readings differ with distance.
struct DistanceClasses {
  std::vector<DistanceClass> classes;  ///< in rising order
  std::string shortfall;  ///< why there are none, as in "4 time steps ...: 10 are needed"
};

/// What there must be to fit a variogram to.
inline constexpr std::size_t least_gauges = 5;
inline constexpr std::size_t least_steps = 10;

/// Each gauge's readings are standardised by their own mean and standard deviation over the steps
/// that it reports, so that what lasts (a wetter hill) is no difference; then half the mean square
/// difference of two gauges over the steps that both report, `least_steps` at least, is 1 less
/// their correlation. Distances are parted in classes, four to each doubling.
///
/// `sample`: a column for each site. With up to 200 gauges every pair counts; with more, pairs of
/// 1, 2, 3, 4, 6, 8, 12 ... gauges apart along the sites' order, so that all distances are there,
/// near ones more: 20,000 at most. Cost: so many times the sample's steps, 1 nanosecond each.
DistanceClasses distance_classes(const StepSample& sample, const Sites& sites, unsigned threads);

}  // namespace thiessen
