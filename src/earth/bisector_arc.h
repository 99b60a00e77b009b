#pragma once

#include <utility>

#include "earth/conformal_sphere.h"

namespace thiessen {

/// The great circle of points equally far from two others, by the angle from their middle, growing
/// to the left of the way from the first to the second; the first's side is on its left.
class BisectorArc {
 public:
  /// `chord`: from the first to the second. Requires different points; where they are antipodes any
  /// point of the circle stands for the middle.
  BisectorArc(Direction first, Direction second, Direction chord);
  BisectorArc(Direction first, Direction second) : BisectorArc(first, second, second - first) {}

  /// Radians from either place to the middle of them.
  double half_separation() const { return half_separation_; }
  Direction at(double angle) const;
  /// Off the circle by an angle, positive to the second's side.
  Direction at(double angle, double offset) const;
  /// The way on across the circle from there, a unit vector.
  Direction across(double angle, double offset) const;
  /// In [-pi, pi].
  double angle_of(Direction p) const;
  /// The angles of an edge's two ends, the second not before the first. Requires that the edge is
  /// no longer than half a circle.
  std::pair<double, double> between(Direction start, Direction end) const;
  /// The way across the circle, to the second's side: the same at all its points.
  Direction forward() const { return cross(left_, middle_); }

 private:
  Direction middle_;
  Direction left_;
  double half_separation_;
};

}  // namespace thiessen
