#pragma once

#include <optional>

#include "earth/bisector_arc.h"
#include "geometry/point.h"

namespace thiessen {

/// The point at equal geodesic distance of three places that lies near `start`; none where it is
/// not found: near the antipode of places that are near each other distances hardly differ, and may
/// be equal at no point or at several. By Newton's method. Accuracy: the distances agree to 1e-7
/// metres. Cost: three geodesics for each of two or three steps.
std::optional<Point> equidistant_point(Point a, Point b, Point c, Point start);

/// The edge between the cells of two places: the points at equal geodesic distance of both. Points
/// on it are told by those of the conformal sphere's bisector, a great circle, from which they are
/// up to 15 km away.
class GeodesicBisector {
 public:
  GeodesicBisector(Point first, Point second, const BisectorArc& arc)
      : arc_(arc), first_(first), second_(second) {}

  const BisectorArc& arc() const { return arc_; }

  /// Longitude and latitude in degrees of the bisector's point across from the great circle's point
  /// at that angle. Where distances do not tell how far it is, near the antipodes of places that
  /// are near each other or where the two are a few micrometres apart, that of a change of sign of
  /// their difference, or the great circle's. Accuracy: 1e-5 metres, but for places so near each
  /// other that 15 nanometres of distance are more. Cost: two geodesics a step, one or two steps.
  Point at(double angle) const;
  /// How far the bisector may be from the great circle, and more, in degrees.
  static double farthest_off() { return 0.5; }

 private:
  std::optional<Point> by_newton(Point start) const;
  std::optional<Point> by_bracket(Point start) const;
  double nearer_to_second(Point p) const;

  BisectorArc arc_;
  Point first_;
  Point second_;
};

}  // namespace thiessen
