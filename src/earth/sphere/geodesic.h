#pragma once

#include "earth/sphere/small_angles.h"
#include "earth/sphere/sphere_scale.h"
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

/// Whether short_path is right to a tenth of `accuracy` metres for a path with such a half chord on
/// the unit sphere: 41 km for an accuracy of 1e-7 metres, 73 km for 1e-6; no more than 0.024.
bool is_short_path(double half, double accuracy);

/// An end of a short path: its direction on the conformal sphere, and the sphere's scale there.
struct ScaledEnd {
  Direction direction;
  double scale;
};
/// The length in metres of a short path: see is_short_path. `half` is half the chord between its
/// ends. The scale is summed along the great circle by Simpson's rule; for many paths from one
/// place its scale is looked up once. The geodesic bends to where the scale k is less: over an
/// angle s by g s^2 / 8 in the middle, where g is the growth of ln k straight across the path, and
/// so it is shorter by k g^2 s^3 / 24.
inline double short_path(const SphereScale& scale, const ScaledEnd& from, const ScaledEnd& to,
                         double half) {
  // The middle of the chord lies so much below the sphere.
  const double square = half * half;
  const double stretch = 1 + square * (1. / 2 + square * (3. / 8 + square * (5. / 16)));
  const Direction a = from.direction;
  const Direction b = to.direction;
  const double sine = (a.z + b.z) / 2 * stretch;
  const double middle = scale.at(sine);
  // The growth to the north is `growth` times the cosine of the latitude, and the path's way to the
  // east (a x b).z divided by that cosine.
  const double growth = sine * (-0.0067387 + 0.000074 * sine * sine);
  const double across = growth * (a.x * b.y - a.y * b.x);  // g s
  return small_arc_sine(half) / 3 * (from.scale + (4 - across * across / 4) * middle + to.scale);
}

/// A lower bound, in metres, on how much farther the place of `second` is than the place of
/// `first`, anywhere within `reach` metres of the point where both paths arrive. `apart`: at least
/// the distance between the two places, in metres. distance_growth.cpp derives it. Accuracy: 1e-7
/// metres.
double least_difference(const Arrival& first, const Arrival& second, double apart, double reach);

}  // namespace thiessen
