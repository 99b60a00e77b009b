#pragma once

#include <utility>

#include "geometry/direction.h"

namespace thiessen {

/// The great circle of the points that are equally far from two places on the sphere. Its points
/// are told by their angle from the middle of the two places, which grows to the left of the way
/// from the first to the second. The first place's side lies to the left of the circle.
class BisectorArc {
 public:
  /// `chord` is the vector from the first place to the second. Requires different points. Where
  /// they are antipodes every point of the circle is a middle, and any of them is taken.
  BisectorArc(Direction first, Direction second, Direction chord);
  BisectorArc(Direction first, Direction second) : BisectorArc(first, second, second - first) {}

  /// Half the angle between the two places, in radians: from either of them to the middle.
  double half_separation() const { return half_separation_; }
  /// The point of the circle at an angle, a unit vector.
  Direction at(double angle) const;
  /// The point `offset` radians off the circle, straight across from the circle's point at `angle`;
  /// a positive offset leads to the second place's side.
  Direction at(double angle, double offset) const;
  /// The unit tangent at the point at(angle, offset) that leads on across the circle, to the second
  /// place's side.
  Direction across(double angle, double offset) const;
  /// The angle, in [-pi, pi], of the circle's point that is nearest to p.
  double angle_of(Direction p) const;
  /// The angles of an edge's two ends, the second not before the first. Requires an edge no longer
  /// than half a circle.
  std::pair<double, double> between(Direction start, Direction end) const;
  /// The unit vector that leads across the circle to the second place's side; it is the same at all
  /// points of the circle.
  Direction forward() const { return cross(left_, middle_); }

 private:
  Direction middle_;
  Direction left_;
  double half_separation_;
};

}  // namespace thiessen
