#pragma once

#include <span>

#include "rainfall/errors/distance_classes.h"
#include "rainfall/errors/variogram.h"

namespace thiessen {

/// The model that comes nearest to what the classes tell: by least squares, each class weighing as
/// the number of its pairs over the square of what the model says there, but no less than a
/// thousandth of the largest class (N. Cressie, Fitting variogram models by weighted least squares,
/// 1985). The nugget and the sill are solved for, neither of them negative; range and exponent are
/// searched on a grid that is laid finer round the best three times, ranges from a third of the
/// least distance to ten times the largest; the spherical model is taken where it comes nearer than
/// all of these.
///
/// Requires a class of positive semivariance at a positive distance. Cost: some 5,000 times the
/// classes, 2 milliseconds.
VariogramModel fit_variogram(std::span<const DistanceClass> classes);

}  // namespace thiessen
