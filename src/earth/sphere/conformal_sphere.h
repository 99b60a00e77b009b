#pragma once

#include "geometry/direction.h"
#include "geometry/point.h"

namespace thiessen {

/// The conformal map of the WGS 84 ellipsoid onto the unit sphere: longitudes stay, latitudes
/// become conformal ones, and small circles on the one are nearly circles on the other. Its scale
/// varies by 0.34 % from the equator to the poles, so the nearest place on the sphere is also the
/// nearest on the ellipsoid except for points near an edge between cells: 0.08 % of the Earth for a
/// network that spans it, a hundredth of that for one of 500 km. `position` is longitude and
/// latitude in degrees. Accuracy: 1e-15. Source: J. P. Snyder, Map projections: a working manual,
/// 1987, equation 3-1.
Direction on_sphere(Point position);

/// The largest ratio between scales of the conformal map, rounded up. A point that is this many
/// times as far away as another on the sphere, measured along chords too, is farther away on the
/// ellipsoid.
inline constexpr double scale_variation = 1.004;

/// The vector on_sphere(b) - on_sphere(a), right to 1e-14 of its length however near the two points
/// are. The longitude of b may be any number of turns away. Cost: 0.3 microseconds where they are
/// near.
Direction chord_on_sphere(Point a, Point b);

/// The scale of the conformal map: metres on the ellipsoid for a radian on the sphere, at
/// directions whose z is `sine`. Accuracy: 1e-13 of it.
double scale_on_earth(double sine);

/// The sine of the geographic latitude where that of the conformal one is `sine`. Accuracy: 3e-8.
inline double sine_of_latitude(double sine) {
  // The two latitudes differ by the sine of twice the conformal one, 0.0033566 times, and that of
  // four times the same.
  constexpr double first = 0.00335655;
  constexpr double second = 6.572e-6;
  const double square_sine = sine * sine;
  const double square_cosine = 1 - square_sine;
  const double gain = 2 * (first + 2 * second * (square_cosine - square_sine));
  return sine * (1 + square_cosine * gain * (1 - square_sine * gain / 2));
}

/// A tangent vector at a point of the sphere, by its components along the axes of axes_at.
struct Tangent {
  double east;
  double north;
};
/// The components to the east and to the north at p of a vector. At a pole they are those of the
/// meridian 0.
Tangent tangent_at(Direction p, Direction vector);

/// The unit tangents to the east and to the north at a point of the sphere.
struct Axes {
  Direction east;
  Direction north;
};
/// The axes at p; at a pole they are those of the meridian 0.
Axes axes_at(Direction p);

/// The inverse of on_sphere: longitude in [-180, 180] and latitude, in degrees. Requires a vector
/// other than zero; its length plays no part.
Point from_sphere(Direction direction);

/// A stereographic projection of the conformal sphere from one of its points. Circles remain
/// circles, so the Delaunay triangulation of the projections, closed at infinity by the pole
/// itself, is the triangulation of the whole sphere, without a seam.
class StereographicChart {
 public:
  explicit StereographicChart(Direction pole);
  /// The point of the plane for a direction. What is counter-clockwise seen from outside the sphere
  /// stays counter-clockwise. Requires a direction other than the pole.
  Point project(Direction p) const;
  /// The inverse of project: a unit vector.
  Direction unproject(Point p) const;
  bool is_pole(Direction p) const { return dot(p - pole_, p - pole_) == 0; }

 private:
  Direction pole_;
  Direction east_;
  Direction north_;
};

}  // namespace thiessen
