#pragma once

#include <string>

#include "geometry/polygon.h"

namespace thiessen {

/// The area in the square of the coordinates' unit. Holes count negative, in whatever direction
/// rings run.
double plane_area(const MultiPolygon& shape);

/// The first fault that GEOS finds in a shape, with its place; empty where the shape is valid.
std::string validity_fault(const MultiPolygon& shape);

/// The union of the shells minus the union of the holes: each piece of ground once.
MultiPolygon made_valid(const MultiPolygon& shape);

/// The area in dispute: how far the two rules for what a shape covers, even-odd and winding number
/// (shells counting as positive and holes as negative), differ. It is the greatest difference of
/// the areas of the whole (`valid` is made_valid(shape)), of the shells, of the holes, and of the
/// rings together, so that two faults cannot make up for each other. It is 0 where the winding
/// number is 0 or 1 everywhere.
double disputed_area(const MultiPolygon& shape, const MultiPolygon& valid);

}  // namespace thiessen
