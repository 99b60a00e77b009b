#pragma once

#include "earth/conformal_sphere.h"
#include "geometry/point.h"

namespace thiessen {

/// The shortest path on the WGS 84 ellipsoid from a place to a point, as it arrives there.
/// Positions are longitude and latitude in degrees. Source: C. F. F. Karney, Algorithms for
/// geodesics, 2013.
struct Arrival {
  double distance;  ///< metres, to 15 nanometres
  double east;      ///< of the unit vector along the path, away from the place: the direction in
  double north;     ///< which the distance grows
};

/// Cost: 1 microsecond, near the antipode of the place 5.
Arrival arrival(Point place, Point at);
double geodesic_distance(Point a, Point b);

/// A position and its direction on the conformal sphere.
struct EarthPoint {
  explicit EarthPoint(Point p) : position(p), direction(on_sphere(p)) {}
  explicit EarthPoint(Direction d) : position(from_sphere(d)), direction(d) {}
  EarthPoint(Point p, Direction d) : position(p), direction(d) {}
  Point position;
  Direction direction;
};

/// The same with a distance that is right to a tenth of `accuracy` metres; its direction may be the
/// sphere's. Where the path is short, up to 20 km for 1e-6 metres and 190 km for 1e-3, the sphere's
/// scale is summed along its great circle by Simpson's rule. Cost: then a tenth.
Arrival arrival(const EarthPoint& place, const EarthPoint& at, double accuracy);

/// The same, seen on the sphere.
struct SphereArrival {
  double distance;
  Direction onward;  ///< the unit tangent in which the distance grows; none where there is no path
};
SphereArrival sphere_arrival(const EarthPoint& place, Direction at, double accuracy);

/// What the distance from the place of `second` exceeds that from the place of `first` by, in
/// metres, at the least, anywhere within `reach` metres of the point where both arrived; `apart`:
/// no less than the distance between the two places. See distance_growth.cpp. Accuracy: 1e-7
/// metres.
double least_difference(const Arrival& first, const Arrival& second, double apart, double reach);

}  // namespace thiessen
