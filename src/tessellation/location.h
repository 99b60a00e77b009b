#pragma once

#include "tessellation/structure.h"

namespace thiessen {

/// The vertex whose simplex holds q; where q is outside the hull, one with the infinite point whose
/// facet q sees. Walks from `hint` through facets that have q beyond them, which ends, for the
/// simplices of a Delaunay tessellation seen from q do not lie before each other in a circle.
/// Requires a dimension d of at least 1 and q within what the points span. Cost: the simplices on
/// the way.
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
