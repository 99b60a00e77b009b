#pragma once

#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// A piece of the plane between lines.
struct RingFace {
  Polygon shape;  ///< outer ring counter-clockwise, holes clockwise
  double area = 0;
  Point within;  ///< a point inside the piece
};

/// Parts the plane along rings that may cross each other and themselves, and returns every bounded
/// piece. Pieces beside each other share their edges vertex for vertex.
///
/// With a `grid` above 0 the rings' vertices and crossings are first moved to multiples of it, and
/// edges that pass a vertex within half of it are led through it (snap rounding, by GEOS). What is
/// narrower than the grid falls together. Without one the noding is GEOS's in doubles. Throws Error
/// where GEOS cannot part the plane. Cost: n log n in vertices and crossings.
std::vector<RingFace> faces_of(std::span<const Ring> rings, double grid);

/// The union of some faces of one call of faces_of, as a valid shape: pieces beside each other grow
/// together, and rings touch in single points at most. Vertices stay as they are. Cost: n log n.
MultiPolygon united(std::span<const RingFace* const> faces);

}  // namespace thiessen
