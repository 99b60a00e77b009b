#pragma once

#include <optional>

#include "earth/sphere/bisector_arc.h"
#include "earth/sphere/geodesic.h"
#include "geometry/point.h"

namespace thiessen {

/// A point of the bisector of two places.
struct BisectorPoint {
  double offset;   ///< radians across from the great circle, to the second place's side
  Point position;  ///< longitude and latitude in degrees
  /// False where distances do not tell well where the point is: near the antipodes of the places,
  /// or where the places are a few micrometres apart. The point is then where the computed
  /// difference of distances changes its sign, or on the great circle.
  bool is_exact = false;
  double uncertainty = 0;  ///< radians: what distances, right to 15 nanometres, cannot tell
};

/// The edge between the cells of two places: the points at equal geodesic distance of both. Each
/// point is told by its relation to the great circle that is the edge on the conformal sphere: by
/// an angle along that circle, and by an offset straight across from it, up to 30 km.
class GeodesicBisector {
 public:
  /// `accuracy` is in metres, at least 1e-6.
  GeodesicBisector(const EarthPoint& first, const EarthPoint& second, const BisectorArc& arc,
                   double accuracy)
      : arc_(arc), first_(first), second_(second), accuracy_(accuracy) {}

  const BisectorArc& arc() const { return arc_; }
  double accuracy() const { return accuracy_; }

  /// The bisector's point straight across from the great circle's point at `angle`; `offset` is a
  /// first guess in radians. It is right to the accuracy (1e-5 metres where it is not exact) or to
  /// the uncertainty, whichever is more. Cost: two geodesics a step and one or two steps; some 20
  /// steps where it is not exact.
  BisectorPoint find(double angle, double offset = 0) const;
  /// An upper bound, in radians, on how far the bisector is from the great circle up to an angle.
  double farthest_off(double angle) const;

 private:
  std::optional<BisectorPoint> by_newton(double angle, double offset) const;
  std::optional<double> by_bracket(double angle) const;
  double nearer_to_second(Point p) const;
  Point at(double angle, double offset) const;

  BisectorArc arc_;
  EarthPoint first_;
  EarthPoint second_;
  double accuracy_;
};

}  // namespace thiessen
