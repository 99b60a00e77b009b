#pragma once

#include <vector>

#include "tessellation/conflict_zone.h"
#include "tessellation/structure.h"

namespace thiessen {

/// Adds a forming point (section 2.2). The object keeps its lists from one point to the next, so
/// that they need not be allocated again.
template <int Dimension>
class Insertion {
 public:
  /// Inserts the point q, and returns one of its vertices. Requires that the structure has a
  /// position for q; that `first` is the vertex at which locate found this position, and no forming
  /// point of it is equal to q; and a dimension of at least 1, which q does not raise.
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
  std::vector<VertexId> new_vertices_;  // one for each facet of the conflict zone's rim
  std::vector<PointId> ring_;           // the points of the rim, used in the plane
};

}  // namespace thiessen
