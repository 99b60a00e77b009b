#pragma once

#include <vector>

#include "earth/conformal_sphere.h"
#include "rainfall/methods/stolen_area.h"

namespace thiessen {

/// The area of a triangle of the unit sphere, positive where its corners are seen counter-clockwise
/// from outside; less than half the sphere. Accuracy: 1e-12 of it, and 1e-16 of its longest side.
/// Source: F. Eriksson, On the measure of solid angles, 1990.
double spherical_area(Direction a, Direction b, Direction c);

/// What a point of the unit sphere would take from the cells of gauges. From a gauge on the rim of
/// its zone it takes what lies between the new edge, which ends at the centres of the point and the
/// gauge with the gauges before and after it on the rim, and the vertices of the zone that the
/// gauge forms, which lie in a row: a convex polygon, cut into triangles. Accuracy: 1e-12 of all
/// that is taken, but within a metre of the hull, where centres are far away and not well known.
class SphereStolenAreas {
 public:
  /// Takes the vertices of a tessellation as they are now; `gauges`: by point, where they are on
  /// the sphere. Cost: theirs.
  void take(const Topology<2>& topology, const std::vector<Direction>& gauges);

  /// From each gauge on the zone's rim, in its order. Requires the zone of x in the tessellation
  /// that was taken, without the infinite point. Cost: 0.3 microseconds for four vertices.
  void find(const Topology<2>& topology, const ConflictZone<2>& zone,
            const std::vector<Direction>& gauges, Direction x,
            std::vector<StolenArea>& areas) const;

 private:
  std::vector<Direction> centres_;  // by vertex
};

}  // namespace thiessen
