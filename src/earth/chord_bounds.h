#pragma once

#include "earth/conformal_sphere.h"

namespace thiessen {

/// A point of the WGS 84 ellipsoid, of longitude and latitude in degrees, in metres from the
/// Earth's centre. Latitudes beyond 90 degrees go on over the pole. Accuracy: 3 nanometres.
Direction on_ellipsoid(Point position);

/// The point of the ellipsoid below a point of space near it, longitude and latitude in degrees,
/// and how far it is from there, in metres.
struct FootPoint {
  Point position;
  double height;
};
FootPoint below(Direction at);

/// How long the geodesic between two points of the ellipsoid may be whose chord, straight through
/// the Earth, has that length; metres. Its curvature is nowhere less than that of a circle of the
/// polar radius of curvature, a^2/b, and nowhere more than that of the meridian at the equator,
/// b^2/a. So it is no shorter than the arc of the one over that chord, for no shorter way leads
/// round the ellipsoid, which is the common part of balls of that radius; and no longer than the
/// arc of the other (A. Schur's theorem on arcs), where that is no more than half a circle.
double shortest_over_chord(double chord);
double longest_over_chord(double chord);

/// What the square of a place's chord must exceed that of another's, of length `chord`, by, for its
/// geodesic to be the longer for certain; square metres. 4.5e-17 of the chord's fourth power, 30
/// micrometres of a chord of 10 km and 30 metres at 1,000 km; infinite near the antipode.
double least_certain_excess(double chord);

/// The same for two places no farther from each other than an eighth of the chord, for each two
/// metres between them: metres; infinite for chords above 7,800 km. Chords of places near each
/// other are wrong alike.
double least_certain_excess_apiece(double chord);

}  // namespace thiessen
