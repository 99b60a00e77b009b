#pragma once

#include <span>
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
/// boxes contain it. The edges are put in another order.
MultiPolygon link_rings(std::span<DirectedEdge> edges);
inline MultiPolygon link_rings(std::vector<DirectedEdge>&& edges) {
  return link_rings(std::span(edges));
}

}  // namespace thiessen
