#pragma once

#include <span>

#include "rainfall/errors/distance_classes.h"
#include "rainfall/errors/variogram.h"

namespace thiessen {

/// Fits a variogram model to distance classes by weighted least squares.
///
/// The weight of a class is the number of its pairs over the square of the model's value there, but
/// that value counts as no less than a thousandth of the largest class (N. Cressie, Fitting
/// variogram models by weighted least squares, 1985). Nugget and sill are solved for and are never
/// negative. Range and exponent are searched on a grid, which is refined round the best point three
/// times; ranges go from a third of the least distance to ten times the largest. The spherical
/// model is taken where it fits better than all stable ones.
///
/// Requires a class of positive semivariance at a positive distance. Cost: some 5,000 times the
/// number of classes, 2 milliseconds.
VariogramModel fit_variogram(std::span<const DistanceClass> classes);

/// The same with an exponential model: the stable shape with the exponent 1.
VariogramModel fit_exponential(std::span<const DistanceClass> classes);

}  // namespace thiessen
