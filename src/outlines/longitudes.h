#pragma once

#include <string>

#include "geometry/polygon.h"
#include "outlines/wide_edges.h"

namespace thiessen {

/// Makes longitudes (degrees) run on over the antimeridian, each ring as ring_as_meant reads it;
/// what was assumed of wide edges is added to `found`.
///
/// Each polygon is moved by whole turns so that its least longitude lies in [-180, 180), and its
/// holes with it. A polygon with a ring that winds round the Earth is closed over a pole and cut at
/// the antimeridian, as add_polygon says. Returns an empty text, or the fault of a ring: an edge
/// whose way is not known, or a ring that add_polygon refuses.
std::string unwrap_longitudes(MultiPolygon& shape, WideEdges& found);

}  // namespace thiessen
