#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/point.h"
#include "tessellation/topology.h"

namespace thiessen {

/// What the points span.
enum class Span { nothing, point, line, plane };

/// The Voronoi and Delaunay tessellations of points in the plane, changed point by point (J. C.-H.
/// Chang, Construction of the Voronoi and Delaunay tessellations, 1982, sections 2.2 and 2.4).
/// There is no initial simplex: a point at infinity closes the hull, and what the points span is
/// explicit, for simplices exist only once they span the plane. Degenerate positions are no special
/// case: every decision is exact, and points on one circle are told apart by their coordinates
/// (in_perturbed_circle), so the same points give the same simplices in whatever order they come.
/// Cost: n log n for n points at once, whatever their order; one insertion log n at best, the
/// square root of n without a near hint. Memory: 52 bytes a point.
class Tessellation {
 public:
  /// Adds points; they get the numbers from size() on, in their order. Of equal points one is
  /// inserted; the others' numbers stay unused. Returns for each point the number under which it
  /// was inserted. Requires finite coordinates in the range of predicates.h.
  std::vector<PointId> add_all(std::span<const Point> points);
  /// Adds one point, or finds its number where it is there already.
  PointId add(Point point);

  /// Numbers given so far.
  std::size_t size() const { return positions_.size(); }
  Point position(PointId p) const { return positions_[index(p)]; }
  std::span<const Point> positions() const { return positions_; }
  /// A simplex of p's; no_vertex where p has none.
  VertexId vertex_of(PointId p) const { return vertex_of_[index(p)]; }
  Span span() const;

  /// The simplices, those of the outside (with the infinite point) among them, counter-clockwise.
  /// Requires span() == Span::plane.
  const Topology<2>& topology() const { return topology_; }
  /// The points in their order along the line. Requires span() != Span::plane.
  std::vector<PointId> along_line() const;

  /// The nearest point, the lexicographically first of equally near ones; none where there are no
  /// points. Cost: a walk from `hint`.
  std::optional<PointId> nearest(Point to, std::optional<PointId> hint = {}) const;

  /// The nearest point and all that are as near, exactly; nothing where there are no points.
  /// Cost: a walk from `hint`.
  void find_nearest(Point to, std::optional<PointId> hint, std::vector<PointId>& nearest) const;

  /// Calls `visit(neighbour)` for every point whose cell has an edge in common with p's, or would
  /// have but for a tie; never the infinite one.
  template <typename Visit>
  void for_each_neighbour(PointId p, Visit&& visit) const;

 private:
  struct OuterEdge {  // of the deleted zone, counter-clockwise, and the vertex kept beyond it
    PointId from;
    PointId to;
    VertexId beyond;
    std::size_t side;
  };

  PointId insert(PointId q);
  PointId insert_in_line(PointId q);
  PointId insert_in_plane(PointId q);
  void insert_all_in_line(std::span<const PointId> points);
  void raise_to_plane(PointId apex);

  VertexId locate(Point q, VertexId hint) const;
  bool in_conflict(VertexId v, Point q) const;
  void find_deleted_vertices(VertexId first, Point q);
  void find_outer_edges();
  void allocate_new_vertices(PointId q);
  void find_nearest_on_line(Point to, std::vector<PointId>& nearest) const;
  void find_nearest_in_plane(Point to, std::optional<PointId> hint,
                             std::vector<PointId>& nearest) const;

  std::vector<Point> positions_;
  std::vector<VertexId> vertex_of_;  // one simplex of each point; no_vertex while there are none
  Topology<2> topology_;
  std::vector<PointId> line_;  // in order, while the points span no plane
  VertexId last_ = no_vertex;  // where the next walk starts
  bool plane_ = false;

  // Lists of the insertion's steps, kept to save their allocation.
  std::vector<VertexId> deleted_;
  std::vector<char> is_deleted_;  // by vertex
  std::vector<OuterEdge> outer_edges_;
};

template <typename Visit>
void Tessellation::for_each_neighbour(PointId p, Visit&& visit) const {
  const VertexId first = vertex_of_[index(p)];
  VertexId v = first;
  do {
    const std::size_t i = topology_.corner_of(v, p);
    const PointId next = topology_.forming(v)[(i + 1) % 3];
    if (next != infinite_point) visit(next);
    v = topology_.neighbour(v, (i + 1) % 3);
  } while (v != first);
}

}  // namespace thiessen
