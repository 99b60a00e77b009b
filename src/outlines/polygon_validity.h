#pragma once

#include <string>

#include "geometry/polygon.h"

namespace thiessen {

/// In the square of the coordinates' unit; holes count negative, whatever direction rings run in.
double plane_area(const MultiPolygon& shape);

/// Empty where the shape is valid, else what GEOS finds wrong and where.
std::string validity_fault(const MultiPolygon& shape);

/// The union of the shells less the union of the holes: each piece of ground once.
MultiPolygon made_valid(const MultiPolygon& shape);

/// How far the rules differ by which one may say what a shape covers, even-odd and winding number
/// (shells counting as positive and holes as negative): the greatest difference of the areas of the
/// whole (`valid` is made_valid(shape)), of the shells, of the holes, and of the rings together, so
/// that two faults cannot make up for each other. 0 where the winding number is 0 or 1 everywhere.
double disputed_area(const MultiPolygon& shape, const MultiPolygon& valid);

}  // namespace thiessen
