#pragma once

#include <cstddef>

#include "tessellation/tessellation.h"

namespace thiessen {

/// Calls visit(a, b, v, side) for every two points that are joined by a side of two triangles, once
/// each: the vertex v lies to the left of a→b, and the vertex across its side of that number to the
/// right. One of the two vertices may be infinite, the points are not.
template <typename Visit>
void for_each_joined_pair(const Topology<2>& topology, Visit&& visit) {
  topology.for_each_vertex([&](VertexId v) {
    for (std::size_t side = 0; side < 3; ++side) {
      if (topology.neighbour(v, side) < v) continue;
      const PointId a = topology.forming(v)[(side + 1) % 3];
      const PointId b = topology.forming(v)[(side + 2) % 3];
      if (a != infinite_point && b != infinite_point) visit(a, b, v, side);
    }
  });
}

}  // namespace thiessen
