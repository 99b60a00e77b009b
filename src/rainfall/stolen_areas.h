#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tessellation/conflict_zone.h"

namespace thiessen {

/// What a point that came to a tessellation would take from the cell of a gauge.
struct StolenArea {
  PointId gauge;
  double area;
};

/// What the point whose conflict zone it is would take from each cell, in the order of the zone's
/// rim. From a gauge on the rim it takes what lies between the new edge, which ends at the centres
/// of the point and the gauge with the gauges before and after it on the rim, and the vertices of
/// the zone that the gauge forms, which lie in a row. Requires a zone in the plane without the
/// infinite point. `centres`, of the plane or the sphere, has
///     Centre old(VertexId)             a vertex of the tessellation,
///     Centre fresh(PointId, PointId)   the centre of the point and two gauges,
///     double area(Centre, Centre, Centre)  of a triangle, positive counter-clockwise;
/// each polygon is convex, so nothing cancels out. Cost: the zone's vertices, three times each.
template <typename Centres>
void find_stolen_areas(const Topology<2>& topology, const ConflictZone<2>& zone,
                       const Centres& centres, std::vector<StolenArea>& areas) {
  using Centre = typename Centres::Centre;
  const auto& rim = zone.rim();
  const auto begin_of = [&](const ConflictZone<2>::Facet& facet) {
    return topology.forming(facet.inside)[facet.side == 2 ? 0 : facet.side + 1];
  };
  areas.clear();
  const PointId first = begin_of(rim.front());
  const Centre last = centres.fresh(begin_of(rim.back()), first);
  Centre before = last;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const PointId gauge = begin_of(rim[i]);
    const bool is_last = i + 1 == rim.size();
    const Centre after = is_last ? last : centres.fresh(gauge, begin_of(rim[i + 1]));
    const auto& end = i == 0 ? rim.back() : rim[i - 1];
    double area = 0;
    VertexId v = rim[i].inside;
    Centre from = centres.old(v);
    for (;;) {
      const std::size_t corner = topology.corner_of(v, gauge);
      const std::size_t across = corner == 2 ? 0 : corner + 1;
      if (v == end.inside && across == end.side) break;
      v = topology.neighbour(v, across);
      const Centre to = centres.old(v);
      area += centres.area(after, from, to);
      from = to;
    }
    area += centres.area(after, from, before);
    areas.push_back({gauge, std::max(0.0, area)});
    before = after;
  }
}

}  // namespace thiessen
