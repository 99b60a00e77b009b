#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tessellation/id_table.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// Which of the vertices round a point in space are one vertex: those of points on one sphere; and
/// which of those with the infinite point stand for one ray: those of facets on one circle.
/// Decided exactly. Cost: one predicate for each pair of neighbours.
class CoincidingVertices {
 public:
  /// Requires a span of the space, the star of p, and that both outlive this.
  CoincidingVertices(const Tessellation<3>& tessellation, const Star<3>& star, PointId p);

  /// A number below the star's number of vertices, which coinciding ones share.
  std::size_t group_of(VertexId v) const;
  bool coincide(VertexId v, VertexId w) const { return group_of(v) == group_of(w); }
  /// By group, the vertex whose forming points come first by coordinates.
  const std::vector<VertexId>& first() const { return first_; }
  /// Of a vertex with the infinite point: the one within, across the hull's facet.
  VertexId inside(VertexId v) const;

 private:
  template <typename Visit>
  void for_each_pair(PointId p, Visit visit) const;
  void unite_spheres(PointId p);
  void unite_circles(PointId p);
  void unite(VertexId v, VertexId w);
  void find_first();

  const Tessellation<3>& tessellation_;
  const Star<3>& star_;
  mutable IdTable<1> place_;  // in the star
  mutable std::vector<std::size_t> same_as_;
  std::vector<VertexId> first_;
};

/// A vertex's forming points in the order of their coordinates.
std::array<SpacePoint, 4> in_order(const Tessellation<3>& tessellation, VertexId v);

}  // namespace thiessen
