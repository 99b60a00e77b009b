#pragma once

#include <optional>

#include "earth/bisector_arc.h"
#include "geometry/point.h"

namespace thiessen {

/// A point at equal geodesic distance, `radius` in metres, of three places.
struct Equidistant {
  Point position;
  double radius;
};

/// The one that lies near `start`; none where it is not found: near the antipode of places that are
/// near each other distances hardly differ, and may be equal at no point or at several. By Newton's
/// method. Accuracy: the distances agree to 1e-7 metres. Cost: four geodesics for each of one to
/// three steps.
std::optional<Equidistant> equidistant_point(Point a, Point b, Point c, Point start);

/// A point of a bisector. Where distances do not tell where it is, near the antipodes of places
/// that are near each other or where the two are a few micrometres apart, not exact: where their
/// difference changes its sign, or of the great circle.
struct BisectorPoint {
  Point position;  ///< longitude and latitude in degrees
  bool is_exact = false;
  double uncertainty = 0;  ///< radians, as far as distances, right to 15 nanometres, tell
};

/// The edge between the cells of two places: the points at equal geodesic distance of both. Points
/// on it are told by those of the conformal sphere's bisector, a great circle, from which they are
/// up to 15 km away.
class GeodesicBisector {
 public:
  GeodesicBisector(Point first, Point second, const BisectorArc& arc)
      : arc_(arc), first_(first), second_(second) {}

  const BisectorArc& arc() const { return arc_; }

  /// The bisector's point across from the great circle's at that angle; `offset`: how far across,
  /// in radians to the second's side, it may be. Accuracy: 1e-6 metres or the uncertainty,
  /// whichever is more. Cost: three geodesics a step, one or two steps.
  BisectorPoint find(double angle, double offset = 0) const;
  /// How far the bisector may be from the great circle, and more, in degrees.
  static double farthest_off() { return 0.5; }

 private:
  std::optional<BisectorPoint> by_newton(Point start) const;
  std::optional<Point> by_bracket(Point start) const;
  double nearer_to_second(Point p) const;

  BisectorArc arc_;
  Point first_;
  Point second_;
};

}  // namespace thiessen
