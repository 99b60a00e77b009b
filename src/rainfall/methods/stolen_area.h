#pragma once

#include "tessellation/conflict_zone.h"

namespace thiessen {

/// The area that a new point of a tessellation would take from the cell of a gauge.
struct StolenArea {
  PointId gauge;
  double area;
};

/// The point at which a facet of a zone's rim begins, going round counter-clockwise with the zone
/// to the left.
inline PointId begin_of(const Topology<2>& topology, const ConflictZone<2>::Facet& facet) {
  return topology.forming(facet.inside)[facet.side == 2 ? 0 : facet.side + 1];
}

}  // namespace thiessen
