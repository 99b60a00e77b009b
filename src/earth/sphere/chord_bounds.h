#pragma once

#include "geometry/direction.h"
#include "geometry/point.h"

namespace thiessen {

/// The point of the WGS 84 ellipsoid at a longitude and latitude in degrees, in metres from the
/// Earth's centre. Latitudes beyond 90 degrees go on over the pole. Accuracy: 3 nanometres.
Direction on_ellipsoid(Point position);

/// The point of the ellipsoid below a point of space near it: its longitude and latitude in
/// degrees, and its distance from that point, in metres.
struct FootPoint {
  Point position;
  double height;
};
/// Projects a point of space near the ellipsoid, in metres from the Earth's centre, onto the
/// ellipsoid.
FootPoint below(Direction at);

/// The longest geodesic, in metres, that two points of the ellipsoid may have if the chord between
/// them, straight through the Earth, is `chord` metres long.
///
/// The curvature of a geodesic is nowhere more than that of the meridian at the equator, whose
/// radius is b^2/a. So the geodesic is no longer than the arc of a circle of that radius over the
/// chord (A. Schur's theorem on arcs), where that is no more than half a circle.
double longest_over_chord(double chord);

/// The excess in square metres that makes a comparison of chords certain: if the square of one
/// place's chord exceeds that of another's, whose length is `chord` metres, by so much, its
/// geodesic is the longer one too. It is 4.5e-17 of the chord's fourth power, which is 30
/// micrometres of a chord of 10 km and 30 metres at 1,000 km, and infinite near the antipode.
///
/// It is told by the longest geodesic over the one chord, and by the chord over which no geodesic
/// is shorter than that. The curvature of a geodesic is nowhere less than that of a circle of the
/// polar radius of curvature, a^2/b, and it is no shorter than the arc of that circle over its
/// chord, because no shorter way leads round the ellipsoid, which is the intersection of balls of
/// that radius.
double least_certain_excess(double chord);

/// The excess, as in least_certain_excess, for each two metres between two places that are no
/// farther from each other than an eighth of the chord: in metres, and infinite for chords above
/// 7,800 km. It is smaller because the chords of places near each other err alike.
double least_certain_excess_apiece(double chord);

}  // namespace thiessen
