#pragma once

#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// A closed line: the last point joins the first, which is not repeated.
using Ring = std::vector<Point>;

/// A part of the plane inside `outer` and outside every hole. Rings of a mended polygon run
/// counter-clockwise outside and clockwise round holes, and touch in single points at most.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

using MultiPolygon = std::vector<Polygon>;

}  // namespace thiessen
