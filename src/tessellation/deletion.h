#pragma once

#include <vector>

#include "tessellation/hole.h"
#include "tessellation/star.h"
#include "tessellation/structure.h"

namespace thiessen {

/// Deleting a forming point (section 2.3): its vertices go, and the hole is filled from the points
/// round it. Keeps its lists from one point to the next.
/// Cost for a point with k neighbours: k^2 at most up to many_points of them, k for each new vertex
/// in space; beyond, that of a tessellation of the neighbours.
template <int Dimension>
class Deletion {
 public:
  static constexpr std::size_t many_points = Dimension == 2 ? 48 : 100;

  /// Deletes p, its number included. Requires that it is there. Returns a vertex near it;
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
  std::vector<Side> rim_;  // of the polygon round p, edge by edge, as the vertices beyond have it
  Hole<Dimension> hole_;
};

}  // namespace thiessen
