#pragma once

#include "geometry/direction.h"
#include "geometry/point.h"

namespace thiessen {

/// The shortest path on the WGS 84 ellipsoid from a place to a point, as it arrives there.
/// Positions are longitude and latitude in degrees. Source: C. F. F. Karney, Algorithms for
/// geodesics, 2013.
struct Arrival {
  double distance;  ///< metres, to 15 nanometres
  double east;      ///< eastward part of the unit vector along which the distance grows
  double north;     ///< northward part of the same unit vector
};

/// The geodesic from `place` as it arrives at `at`. Cost: 1 microsecond; 5 near the antipode of the
/// place.
Arrival arrival(Point place, Point at);
/// The length of the shortest path between two positions, in metres.
double geodesic_distance(Point a, Point b);

/// A position (longitude and latitude in degrees) and its direction on the conformal sphere.
struct EarthPoint {
  explicit EarthPoint(Point p);
  explicit EarthPoint(Direction d);
  EarthPoint(Point p, Direction d) : position(p), direction(d) {}
  Point position;
  Direction direction;
};

/// The geodesic from `place` as it arrives at `at`, with a distance that is right to a tenth of
/// `accuracy` metres; the direction of arrival may be the sphere's. Where the path is short, up to
/// 20 km for an accuracy of 1e-6 metres and 190 km for 1e-3, the sphere's scale is summed along its
/// great circle by Simpson's rule, which costs a tenth of a geodesic.
Arrival arrival(const EarthPoint& place, const EarthPoint& at, double accuracy);

/// An arrival seen on the conformal sphere.
struct SphereArrival {
  double distance;
  Direction onward;  ///< the unit tangent in which the distance grows; none where there is no path
};
/// The geodesic from `place` as it arrives at the direction `at`, with the accuracy that arrival
/// gives.
SphereArrival sphere_arrival(const EarthPoint& place, Direction at, double accuracy);

/// A lower bound, in metres, on how much farther the place of `second` is than the place of
/// `first`, anywhere within `reach` metres of the point where both paths arrive. `apart`: at least
/// the distance between the two places, in metres. distance_growth.cpp derives it. Accuracy: 1e-7
/// metres.
double least_difference(const Arrival& first, const Arrival& second, double apart, double reach);

}  // namespace thiessen
