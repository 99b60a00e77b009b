#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tessellation/id_table.h"
#include "tessellation/star.h"
#include "tessellation/structure.h"

namespace thiessen {

/// The hole that a deleted point leaves, and its filling (section 2.3, steps 2 to 5): each open
/// facet takes for its last forming point the one of the star's whose sphere holds none of the
/// others, until every facet has met its like.
template <int Dimension>
class Hole {
 public:
  /// Of a point and its star, d being what the points span.
  template <int d>
  void open(const Topology<Dimension>& topology, PointId p, const Star<Dimension>& star);
  /// Returns the new vertices, of which the first take the rows of the star's. Cost: for each new
  /// vertex the star's points.
  template <int d>
  const std::vector<VertexId>& fill(Structure<Dimension>& structure);
  /// The same from a tessellation of the star's points, for many of these.
  template <int d>
  const std::vector<VertexId>& fill_from_tessellation(Structure<Dimension>& structure);

 private:
  using Forming = typename Topology<Dimension>::Forming;
  using Key = typename IdTable<std::size_t{Dimension}>::Key;

  /// A simplex without its corner `side`, and the vertex beyond. A point of the hole in that corner
  /// makes a simplex that is not turned over.
  struct Facet {
    Forming forming;
    std::size_t side;
    VertexId outside;
    std::size_t outside_side;
  };

  static Key key_of(const Forming& forming, std::size_t side);
  template <int d>
  PointId apex_of(const Structure<Dimension>& structure, const Facet& facet) const;
  template <int d>
  bool may_complete(const Structure<Dimension>& structure, const Facet& facet, PointId p) const;
  template <int d>
  void add_simplex(Topology<Dimension>& topology, const Forming& forming);
  void meet(Topology<Dimension>& topology, const Facet& facet);
  VertexId next_vertex(Topology<Dimension>& topology);
  const std::vector<VertexId>& finish(Topology<Dimension>& topology);

  template <int d>
  bool is_inside(const Facet& facet, const Forming& forming, std::size_t side) const;

  std::vector<Facet> facets_;  // open ones, and those that have met their like: outside no_vertex
  IdTable<std::size_t{Dimension}> facet_of_;  // by its points
  const Star<Dimension>* star_ = nullptr;
  std::size_t reused_ = 0;  // of the star's rows
  std::vector<VertexId> new_vertices_;
};

}  // namespace thiessen
