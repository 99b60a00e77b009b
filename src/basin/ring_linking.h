#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

struct DirectedEdge {
  Point from;
  Point to;
};

/// The polygons whose boundary the edges are, interior to the left: rings that touch themselves are
/// parted at the point, outer rings run counter-clockwise and each hole stands with the part that
/// it is in. Requires edges that do not cross and at every point as many beginning as ending. Cost:
/// n log n, and for each hole the parts whose boxes hold it.
MultiPolygon link_rings(std::vector<DirectedEdge> edges);

}  // namespace thiessen
