#pragma once

#include <span>

#include "diagram/diagram.h"

namespace thiessen {

/// The Thiessen cells of `places` (longitude and latitude in degrees) on the WGS 84 ellipsoid:
/// nearest by the geodesic. They are drawn in longitude and latitude as far as they come near
/// `frame`, the edges subdivided until their chords are within `tolerance` metres of them.
///
/// It begins with the tessellation of the conformal sphere (SphereTessellation), where up to 0.08 %
/// of the Earth is in another cell. Each vertex becomes the point at equal distance of its three
/// places; a side of a triangle whose circle then holds the point across is flipped, until there is
/// none; edges are points at equal distance of two places. Round the antipode of a network that is
/// small against the Earth the triangles are laid anew: see FarSide.
///
/// Requires at least one place, different ones, longitudes within 360 degrees of the frame's, and a
/// frame no wider than 360 degrees. The result does not depend on `threads`. `accuracy`: of
/// vertices, in metres, at least 1e-6; of chords' ends, tenfold. Cost: n log n for n places; some
/// ten geodesics for each vertex near the frame, and for each edge; and the chords, whose number
/// grows with the square root of the edges' length over the tolerance.
Diagram geodesic_diagram(std::span<const Point> places, const Box& frame, double tolerance,
                         double accuracy, unsigned threads);

}  // namespace thiessen
