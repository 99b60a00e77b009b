#pragma once

#include <vector>

#include "tessellation/conflict_zone.h"
#include "tessellation/structure.h"

namespace thiessen {

/// Adding a forming point (section 2.2). Keeps its lists from one point to the next.
template <int Dimension>
class Insertion {
 public:
  /// Inserts a point, which the structure has a position for. Requires that `first`, where locate
  /// found it, is no simplex of an equal point, and a dimension of at least 1, which the point does
  /// not raise. Returns one of its vertices.
  VertexId insert(Structure<Dimension>& structure, PointId q, VertexId first);

 private:
  using Facet = typename ConflictZone<Dimension>::Facet;

  template <int d>
  VertexId insert_in(Structure<Dimension>& structure, PointId q, VertexId first);
  void fill_ring(Topology<Dimension>& topology, PointId q);
  template <int d>
  void fill_star(Topology<Dimension>& topology, PointId q);
  void link_round_ridge(Topology<Dimension>& topology, std::size_t k, std::size_t i);

  ConflictZone<Dimension> zone_;
  std::vector<VertexId> new_vertices_;  // one for each facet of the zone's rim
  std::vector<PointId> ring_;           // in the plane: the points of the rim
};

}  // namespace thiessen
