#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tessellation/id_table.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// Finds which vertices round a point in space coincide. Finite vertices do where their forming
/// points are on one sphere. Vertices with the infinite point stand for rays, and count as one
/// where their facets of the hull are on one circle. Decided exactly. Cost: one predicate for each
/// pair of neighbours.
class CoincidingVertices {
 public:
  /// Groups the vertices of p's star. Requires that the points span the space, that `star` is the
  /// star of p, and that tessellation and star outlive this object.
  CoincidingVertices(const Tessellation<3>& tessellation, const Star<3>& star, PointId p);

  /// The number of v's group, which coinciding vertices share. It is below the number of vertices
  /// in the star.
  std::size_t group_of(VertexId v) const;
  bool coincide(VertexId v, VertexId w) const { return group_of(v) == group_of(w); }
  /// The vertex of each group number whose forming points come first by coordinates; no_vertex
  /// where the number is not in use.
  const std::vector<VertexId>& first() const { return first_; }
  /// The finite vertex on the inner side of the hull's facet that belongs to v. Requires a vertex
  /// with the infinite point.
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
  mutable IdTable<1> place_;  // by vertex, its place in the star
  mutable std::vector<std::size_t> same_as_;
  std::vector<VertexId> first_;
};

/// The positions of the vertex's forming points, in the order of their coordinates.
std::array<SpacePoint, 4> in_order(const Tessellation<3>& tessellation, VertexId v);

}  // namespace thiessen
