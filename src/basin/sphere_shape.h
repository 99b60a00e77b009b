#pragma once

#include <span>
#include <vector>

#include "basin/basin.h"
#include "earth/sphere/gnomonic_chart.h"
#include "geometry/box.h"

namespace thiessen {

/// The ground of a cell in a basin on the ellipsoid, with few edges, for use in charts. Its edges
/// are great circles of the conformal sphere from corner to corner, each with the area between the
/// true edge and itself. Areas are therefore right, and a part cut off the ground is measured as if
/// the edges bent like parabolas.
class SphereShape {
 public:
  /// How far the ground may reach from its centre, in radians. A shape that reaches farther is left
  /// empty.
  static constexpr double farthest_reach = 0.1;

  /// `bends` are the corners, in rising order, that only bend an edge between cells. They are left
  /// out where the edge is still within `tolerance` metres of the great circle. Edges of the basin
  /// are divided until they are within that too. Cost: the number of corners times its logarithm.
  SphereShape(const Basin& ground, std::span<const Point> bends, double tolerance);

  Direction centre() const { return centre_; }
  /// Radians from the centre to the farthest corner of the box, which is as far as the ground
  /// reaches at most. If it is more than `farthest_reach`, the shape has no rings.
  double reach() const { return reach_; }
  /// The bounding box in longitude and latitude, in degrees.
  const Box& box() const { return box_; }
  /// The ground in the coordinates of a chart. Cost: in proportion to its corners.
  Basin in_chart(const GnomonicChart& chart) const;

 private:
  struct SphereRing {
    std::vector<Direction> corners;
    std::vector<double> bulges;  ///< see Basin::bulges
  };
  struct Part {
    SphereRing outer;
    std::vector<SphereRing> holes;
  };
  class Simplifying;

  std::vector<Part> parts_;
  Direction centre_;
  double reach_ = 0;
  Box box_;
};

}  // namespace thiessen
