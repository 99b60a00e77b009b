#pragma once

#include <optional>

#include "earth/bisector_arc.h"
#include "earth/geodesic.h"
#include "geometry/point.h"

namespace thiessen {

/// A point of a bisector.
struct BisectorPoint {
  double offset;   ///< from the great circle, in radians across it, to the second place's side
  Point position;  ///< longitude and latitude in degrees
  /// Not where distances do not tell well where it is, near the antipodes of the places or where
  /// they are a few micrometres apart: then it is where their difference changes its sign, or on
  /// the great circle.
  bool is_exact = false;
  double uncertainty = 0;  ///< radians, as far as distances, right to 15 nanometres, tell
};

/// The edge between the cells of two places: the points at equal geodesic distance of both. Each is
/// told by the great circle that the conformal sphere has for an edge: by an angle along it, and by
/// how far it is from there, straight across: up to 30 km.
class GeodesicBisector {
 public:
  /// `accuracy`: metres, at least 1e-6.
  GeodesicBisector(const EarthPoint& first, const EarthPoint& second, const BisectorArc& arc,
                   double accuracy)
      : arc_(arc), first_(first), second_(second), accuracy_(accuracy) {}

  const BisectorArc& arc() const { return arc_; }
  double accuracy() const { return accuracy_; }

  /// The bisector's point across from the great circle's at that angle; `offset`: how far it may
  /// be. Right to the accuracy (where it is not exact, to 1e-5 metres) or the uncertainty,
  /// whichever is more. Cost: two geodesics a step, one or two steps; where it is not exact 20
  /// steps or so.
  BisectorPoint find(double angle, double offset = 0) const;
  /// How far the bisector may be from the great circle up to an angle, and more, in radians.
  double farthest_off(double angle) const;

 private:
  std::optional<BisectorPoint> by_newton(double angle, double offset) const;
  std::optional<double> by_bracket(double angle) const;
  double nearer_to_second(Point p) const;
  Point at(double angle, double offset) const { return from_sphere(arc_.at(angle, offset)); }

  BisectorArc arc_;
  EarthPoint first_;
  EarthPoint second_;
  double accuracy_;
};

}  // namespace thiessen
