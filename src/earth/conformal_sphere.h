#pragma once

#include <cmath>

#include "geometry/point.h"

namespace thiessen {

/// A vector in space; a unit vector is a point of the sphere.
struct Direction {
  double x = 0;
  double y = 0;
  double z = 0;

  friend Direction operator+(Direction a, Direction b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Direction operator-(Direction a, Direction b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Direction operator*(double s, Direction a) { return {s * a.x, s * a.y, s * a.z}; }
};

inline double dot(Direction a, Direction b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Direction cross(Direction a, Direction b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Direction a) {
  return std::sqrt(dot(a, a));
}
inline Direction unit(Direction a) {
  return (1 / length(a)) * a;
}

/// The conformal map of the WGS 84 ellipsoid onto the unit sphere: longitudes stay, latitudes
/// become conformal ones, and small circles on the one are nearly circles on the other. Its scale
/// varies by 0.34 % from the equator to the poles, so what is nearest on the sphere is nearest on
/// the ellipsoid but for points near an edge between cells: 0.08 % of the Earth for a network that
/// spans it, a hundredth of that for one of 500 km. `position`: longitude and latitude in degrees.
/// Accuracy: 1e-15. Source: J. P. Snyder, Map projections: a working manual, 1987, equation 3-1.
Direction on_sphere(Point position);

/// The largest ratio of scales, and some more: a point this many times as far as another on the
/// sphere, along chords too, is farther on the ellipsoid.
inline constexpr double scale_variation = 1.004;

/// on_sphere(b) - on_sphere(a), to 1e-14 of its length however near the two are; b's longitude may
/// be any number of turns away. Cost: 0.3 microseconds where they are near.
Direction chord_on_sphere(Point a, Point b);

/// Metres on the ellipsoid for a radian on the sphere where a direction's z is `sine`. Accuracy:
/// 1e-13 of it.
double scale_on_earth(double sine);

/// A tangent vector at a point of the sphere; at a pole as on the meridian 0.
struct Tangent {
  double east;
  double north;
};
Tangent tangent_at(Direction p, Direction vector);

/// The unit tangents there.
struct Axes {
  Direction east;
  Direction north;
};
Axes axes_at(Direction p);

/// The inverse: longitude in [-180, 180] and latitude in degrees. Requires a vector that is not
/// zero.
Point from_sphere(Direction direction);

/// A stereographic projection of the conformal sphere from one of its points. Circles remain
/// circles, so the Delaunay triangulation of the projections, closed at infinity by the pole
/// itself, is that of the sphere: the whole of it, without a seam.
class StereographicChart {
 public:
  explicit StereographicChart(Direction pole);
  /// Counter-clockwise seen from outside the sphere stays counter-clockwise. Requires another point
  /// than the pole.
  Point project(Direction p) const;
  bool is_pole(Direction p) const { return dot(p - pole_, p - pole_) == 0; }

 private:
  Direction pole_;
  Direction east_;
  Direction north_;
};

}  // namespace thiessen
