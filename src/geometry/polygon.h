#pragma once

#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// A closed line: the last point joins the first, which is not repeated.
using Ring = std::vector<Point>;

/// The part of the plane that is inside `outer` and outside every hole. In a mended polygon the
/// outer ring runs counter-clockwise and the holes clockwise, and rings touch in single points at
/// most.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

using MultiPolygon = std::vector<Polygon>;

}  // namespace thiessen
