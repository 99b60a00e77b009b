#pragma once

#include <span>

#include "diagram/diagram.h"

namespace thiessen {

/// The Thiessen cells of `places` (longitude and latitude in degrees) on the WGS 84 ellipsoid,
/// where the nearest place is the one with the shortest geodesic. They are drawn in longitude and
/// latitude as far as they come near `frame`, with edges subdivided until their chords are within
/// `tolerance` metres of them.
///
/// The computation begins with the tessellation of the conformal sphere (SphereTessellation), in
/// which up to 0.08 % of the Earth is in another cell. Each vertex is moved to the point at equal
/// distance of its three places. A side of a triangle is flipped while the circle round that vertex
/// holds the point across the side. Edges are the points at equal distance of two places. Round the
/// antipode of a network that is small against the Earth the triangles are laid anew: see FarSide.
///
/// Requires at least one place, different ones, longitudes within 360 degrees of the frame's, and a
/// frame no wider than 360 degrees. The result does not depend on `threads`. `accuracy`: of
/// vertices, in metres, at least 1e-6; the ends of chords are right to ten times as much. Cost: n
/// log n for n places; some ten geodesics for each vertex near the frame, and for each edge; and
/// the chords, whose number grows with the square root of the edges' length over the tolerance.
Diagram geodesic_diagram(std::span<const Point> places, const Box& frame, double tolerance,
                         double accuracy, unsigned threads,
                         Neighbours neighbours = Neighbours::wanted);

}  // namespace thiessen
