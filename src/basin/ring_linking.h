#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// A directed straight edge of a boundary.
struct DirectedEdge {
  Point from;
  Point to;
};

/// Links directed edges, with the interior to their left, into the polygons that they bound. Rings
/// that touch themselves are divided at the point of touching; outer rings run counter-clockwise,
/// and each hole goes to the part that contains it. Requires edges that do not cross, and as many
/// of them beginning as ending at every point. Cost: n log n, and for each hole the parts whose
/// boxes contain it.
MultiPolygon link_rings(std::vector<DirectedEdge> edges);

}  // namespace thiessen
