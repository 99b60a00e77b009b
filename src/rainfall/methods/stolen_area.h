#pragma once

#include "tessellation/conflict_zone.h"

namespace thiessen {

/// What a point that came to a tessellation would take from the cell of a gauge.
struct StolenArea {
  PointId gauge;
  double area;
};

/// The point at which a facet of a zone's rim begins: counter-clockwise, the zone to its left.
inline PointId begin_of(const Topology<2>& topology, const ConflictZone<2>::Facet& facet) {
  return topology.forming(facet.inside)[facet.side == 2 ? 0 : facet.side + 1];
}

}  // namespace thiessen
