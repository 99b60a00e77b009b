#pragma once

#include <vector>

#include "tessellation/hole.h"
#include "tessellation/star.h"
#include "tessellation/structure.h"

namespace thiessen {

/// Deletes a forming point (section 2.3): its vertices are removed, and the hole is filled with
/// simplices of the points round it. The object keeps its lists from one point to the next, so that
/// they need not be allocated again.
///
/// Cost for a point with k neighbours: at most k^2 in the plane, and k for each new vertex in
/// space, as long as k is at most many_points; beyond that, the cost of a tessellation of the
/// neighbours.
template <int Dimension>
class Deletion {
 public:
  static constexpr std::size_t many_points = Dimension == 2 ? 48 : 100;

  /// Deletes p and frees its number. Requires that p is there. Returns a vertex near it, or
  /// no_vertex where no point is left.
  VertexId remove(Structure<Dimension>& structure, PointId p);

 private:
  struct Side {
    VertexId vertex;
    std::size_t side;
  };

  template <int d>
  VertexId remove_in(Structure<Dimension>& structure, PointId p);
  template <int d>
  bool is_last_off(const Structure<Dimension>& structure, PointId p) const;
  template <int d>
  void fill(Structure<Dimension>& structure, PointId p);

  void fill_polygon(Structure<Dimension>& structure, PointId p);
  Side fill_chain(Structure<Dimension>& structure, std::size_t first, std::size_t last);
  std::size_t apex_of_chain(const Structure<Dimension>& structure, std::size_t first,
                            std::size_t last) const;

  Star<Dimension> star_;
  std::vector<VertexId> new_vertices_;
  std::vector<Side> rim_;  // the hole's edges in order, as sides of the vertices beyond
  Hole<Dimension> hole_;
};

}  // namespace thiessen
