#pragma once

#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// The points at which the geodesic from a to b is bent where it is drawn in chords that are
/// straight in longitude and latitude: those between its ends, in their order, each chord within
/// `tolerance` metres of the geodesic. Positions are in degrees, longitudes in [-180, 180]; chords
/// that span more than 180 degrees go over the antimeridian. Where the geodesic passes a pole, two
/// points stand there, at the longitudes on which it comes and goes; where it ends at one, the end
/// has the longitude of the other end.
/// Law: geodesic_chords(b, a) is geodesic_chords(a, b) in reverse, bit for bit.
/// Cost: three geodesics a chord, and twice as many chords as are needed at most.
std::vector<Point> geodesic_chords(Point a, Point b, double tolerance);

}  // namespace thiessen
