#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tessellation/id_table.h"
#include "tessellation/star.h"
#include "tessellation/structure.h"

namespace thiessen {

/// The hole that a deleted point leaves, and its filling (section 2.3, steps 2 to 5). Each open
/// facet is completed to a simplex by one point of the star: the one with which the simplex' sphere
/// holds no other point of the star. This goes on until every facet has met its twin from the other
/// side.
template <int Dimension>
class Hole {
 public:
  /// Opens the hole that the deletion of p leaves, from the star of p. Requires d = the dimension
  /// that the points span.
  template <int d>
  void open(const Topology<Dimension>& topology, PointId p, const Star<Dimension>& star);
  /// Fills the hole and returns the new vertices, the first of which reuse the rows of the star's.
  /// Cost: for each new vertex, in proportion to the points of the star.
  template <int d>
  const std::vector<VertexId>& fill(Structure<Dimension>& structure);
  /// Fills the hole as fill does, but takes the simplices from a tessellation of the star's points,
  /// which is faster where these are many.
  template <int d>
  const std::vector<VertexId>& fill_from_tessellation(Structure<Dimension>& structure);

 private:
  using Forming = typename Topology<Dimension>::Forming;
  using Key = typename IdTable<std::size_t{Dimension}>::Key;

  /// A facet of the hole: a simplex without its corner `side`, and the vertex beyond. A point of
  /// the hole, put in that corner, makes a simplex that is not turned over.
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

  std::vector<Facet> facets_;  // open facets, and closed ones, whose `outside` is no_vertex
  IdTable<std::size_t{Dimension}> facet_of_;  // by the facet's points
  const Star<Dimension>* star_ = nullptr;
  std::size_t reused_ = 0;  // how many of the star's rows are in use again
  std::vector<VertexId> new_vertices_;
};

}  // namespace thiessen
