#pragma once

#include <optional>

#include "geometry/polygon.h"

namespace thiessen {

/// What a shape covers whose rings cross or run along each other.
struct Ground {
  /// The union of the parts, each less its own holes, as a valid shape. A ring holds what it winds
  /// round at all (the non-zero rule).
  MultiPolygon shape;
  /// The ground on which rules differ: where the winding number, of shells less holes, is neither 0
  /// nor 1. The pieces lie beside each other, and are not united.
  MultiPolygon disputed;
  double area = 0;           ///< of `shape`, in the square of the coordinates' unit
  double disputed_area = 0;  ///< of `disputed`
  /// A corner of the largest disputed piece: where rings cross, if they do there.
  std::optional<Point> place;
};

/// Finds what a shape covers, and where rules for that differ. The winding number of a point counts
/// each shell round it, in whatever direction the shell runs, as 1 and each hole as -1. So an
/// island in a lake, a part that fills another's hole, parts that share an edge and rings that only
/// touch leave nothing in dispute; two parts that overlap, a lobe that runs the other way round,
/// and a hole outside its shell do. Throws as faces_of. Cost: n log n in vertices and crossings.
Ground ground_of(const MultiPolygon& shape);

}  // namespace thiessen
