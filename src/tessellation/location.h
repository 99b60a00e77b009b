#pragma once

#include "tessellation/structure.h"

namespace thiessen {

/// The vertex whose simplex contains q. Where q is outside the hull, it is a vertex with the
/// infinite point whose facet of the hull is visible from q.
///
/// The walk starts at `hint` and goes through facets that have q on their far side. It ends
/// because, seen from q, no simplices of a Delaunay tessellation lie before each other in a circle.
///
/// Requires a dimension d of at least 1, and that q is on what the points span. Cost: in proportion
/// to the simplices on the way.
template <int d, int Dimension>
VertexId locate(const Structure<Dimension>& structure, const PositionIn<Dimension>& q,
                VertexId hint) {
  const Topology<Dimension>& topology = structure.topology();
  VertexId v = structure.finite_vertex(hint);
  VertexId before = no_vertex;
  for (;;) {
    const auto simplex = structure.template simplex<d>(v);
    VertexId next = no_vertex;
    for (std::size_t i = 0; i <= d; ++i) {
      const VertexId w = topology.neighbour(v, i);
      if (w == before || structure.template orientation_with<d>(simplex, i, q) >= 0) continue;
      next = w;
      break;
    }
    if (next == no_vertex) return v;
    if (topology.is_infinite(next)) return next;
    before = v;
    v = next;
  }
}

}  // namespace thiessen
