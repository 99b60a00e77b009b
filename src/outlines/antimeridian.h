#pragma once

#include <span>
#include <vector>

#include "geometry/polygon.h"
#include "outlines/winding_ring.h"

namespace thiessen {

/// A shape in longitude and latitude, with the areas between its chords and the true edges.
struct CurvedShape {
  MultiPolygon shape;
  std::vector<std::vector<double>> bulges;  ///< as Basin::bulges; empty where edges are straight
};

/// Adds the parts of one shape to another.
void append(CurvedShape part, CurvedShape& into);

/// Cuts a polygon at the antimeridian (RFC 7946, section 3.1.9), so that every longitude lies in
/// [-180, 180]. `rings` are its outer ring and its holes, with the interior to the left; they tell
/// whether they hold the south pole, and for the north pole that follows.
///
/// Where the interior crosses the antimeridian it gets an edge on either side of it, and where it
/// holds a pole it gets one along latitude -90 or 90. Points keep their bits. Two rings that share
/// an edge are cut at one point, and an edge's bulge is shared between its pieces. Requires rings
/// that do not cross. Cost: n log n.
CurvedShape cut_at_antimeridian(std::span<const WindingRing> rings);

/// Cuts a shape at the antimeridian whose longitudes run on over it (170 to 190). Requires outer
/// rings that run counter-clockwise. Polygons within [-180, 180] stay as they are, bit for bit.
void cut_at_antimeridian(CurvedShape& shape);

/// Cuts a line at the antimeridian whose longitudes run on over it, into pieces within [-180, 180].
/// A line that only touches it stays whole, and one within stays as it is, bit for bit. Cost:
/// linear in its points and the turns that it spans.
std::vector<std::vector<Point>> cut_at_antimeridian(std::span<const Point> line);

}  // namespace thiessen
