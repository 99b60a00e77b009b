#pragma once

#include <span>
#include <vector>

#include "basin/basin.h"
#include "earth/gnomonic_chart.h"
#include "geometry/box.h"

namespace thiessen {

/// A cell's ground in a basin of the ellipsoid, with few edges, for charts: great circles of the
/// conformal sphere from corner to corner, and for each the area between the true edge and it. So
/// areas are right, and what is cut off it is as if its edges bent like parabolas.
class SphereShape {
 public:
  /// How far the ground may reach from its centre, in radians; of what is larger nothing is kept.
  static constexpr double farthest_reach = 0.1;

  /// `bends`: the corners that only bend an edge between cells, in rising order; they are left out
  /// where the edge is still within `tolerance` metres of the great circle. Edges of the basin are
  /// parted until they are. Cost: the corners, times a logarithm.
  SphereShape(const Basin& ground, std::span<const Point> bends, double tolerance);

  Direction centre() const { return centre_; }
  /// Radians from the centre to the farthest corner; more than `farthest_reach`: it has no rings.
  double reach() const { return reach_; }
  /// In longitude and latitude.
  const Box& box() const { return box_; }
  /// Cost: its corners.
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
