#pragma once

#include <string>

#include "geometry/polygon.h"

namespace thiessen {

/// The area in the square of the coordinates' unit. Holes count negative, in whatever direction
/// rings run.
double plane_area(const MultiPolygon& shape);

/// The first fault that GEOS finds in a shape, with its place; empty where the shape is valid.
std::string validity_fault(const MultiPolygon& shape);

}  // namespace thiessen
