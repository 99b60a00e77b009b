#pragma once

#include <span>
#include <vector>

#include "geometry/polygon.h"
#include "outlines/winding_ring.h"

namespace thiessen {

/// A shape in longitude and latitude, and what its true edges cut off.
struct CurvedShape {
  MultiPolygon shape;
  std::vector<std::vector<double>> bulges;  ///< as Basin::bulges; empty where edges are straight
};

/// Adds the parts of one shape to another.
void append(CurvedShape part, CurvedShape& into);

/// A polygon's rings (the outer one, its holes), interior to the left, cut at the antimeridian (RFC
/// 7946, section 3.1.9): with every longitude in [-180, 180]. Where the interior crosses the
/// antimeridian it gets an edge on either side of it, and where it holds a pole one along latitude
/// -90 or 90. Points keep their bits, and two rings that share an edge are cut at one point; an
/// edge's bulge is shared between its pieces. Rings tell whether they hold the south pole; for the
/// north pole that follows. Requires rings that do not cross. Cost: n log n.
CurvedShape cut_at_antimeridian(std::span<const WindingRing> rings);

/// The same for a shape whose longitudes run on over the antimeridian (170 to 190), outer rings
/// counter-clockwise. Polygons within [-180, 180] stay as they are, bit for bit.
void cut_at_antimeridian(CurvedShape& shape);

}  // namespace thiessen
