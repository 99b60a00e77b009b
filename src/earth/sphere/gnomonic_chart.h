#pragma once

#include "diagram/surface.h"
#include "geometry/direction.h"
#include "geometry/point.h"

namespace thiessen {

/// The gnomonic projection of the conformal sphere round one of its points. It makes straight lines
/// of great circles, which edges between cells nearly are. Coordinates are tangents of angles from
/// the centre, along two axes at right angles.
class GnomonicChart {
 public:
  /// Requires a unit vector.
  explicit GnomonicChart(Direction centre);

  Direction centre() const { return centre_; }
  /// The axes of the coordinates: unit vectors at right angles to the centre.
  Direction east() const { return east_; }
  Direction north() const { return north_; }
  /// The point of the chart for a direction. What is counter-clockwise seen from outside the sphere
  /// stays counter-clockwise. Requires a direction less than a quarter of a turn from the centre.
  Point project(Direction p) const {
    const double scale = 1 / dot(p, centre_);
    return {scale * dot(p, east_), scale * dot(p, north_)};
  }
  /// The inverse of project: a unit vector.
  Direction direction(Point p) const { return unit(centre_ + p.x * east_ + p.y * north_); }
  /// The area on the ellipsoid, in square metres, of a square unit of the chart at a point of it.
  /// Accuracy: 1e-8 of it up to 0.1 from the centre, 1e-13 at the centre.
  double unit_area(Point p) const;

 private:
  Direction centre_;
  Direction east_;
  Direction north_;
  double square_sine_;  // square of the sine of the centre's conformal latitude
  // These are the coefficients of the square of the sphere's scale, in powers of the difference
  // between the square of the sine of the conformal latitude and its value at the centre.
  double scale_;
  double slope_;
  double curve_;
};

/// The surface of the WGS 84 ellipsoid in the coordinates of a gnomonic chart; areas are in square
/// metres.
class ChartSurface : public Surface {
 public:
  explicit ChartSurface(const GnomonicChart& chart) : chart_(chart) {}
  /// The area of the triangle of a, b and the chart's centre; `reference` plays no part. Accuracy:
  /// 1e-8 of it where the triangle is within 0.1 of the centre. Cost: 50 nanoseconds. Source: the
  /// cubature of degree 5 by J. Radon, Zur mechanischen Kubatur, 1948.
  double under(Point a, Point b, double reference) const override;

 private:
  const GnomonicChart& chart_;
};

}  // namespace thiessen
