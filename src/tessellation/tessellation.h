#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/point.h"
#include "geometry/signposts.h"
#include "tessellation/arrangement.h"
#include "tessellation/at_dimension.h"
#include "tessellation/conflict_zone.h"
#include "tessellation/deletion.h"
#include "tessellation/insertion.h"
#include "tessellation/star.h"
#include "tessellation/structure.h"
#include "tessellation/topology.h"

namespace thiessen {

/// The space that the points span, in the order of its dimension.
enum class Span { nothing, point, line, plane, space };

/// The Voronoi and Delaunay tessellations of points in the plane or in space, changed point by
/// point, by insertion and by deletion (J. C.-H. Chang, Construction of the Voronoi and Delaunay
/// tessellations, 1982).
///
/// There is no initial simplex: a point at infinity closes the hull. The dimension that the points
/// span is explicit, and where it is less than that of the space, this is the tessellation of the
/// points' line or plane. Degenerate positions are no special case: every decision is exact, and
/// ties among points on one circle or sphere are broken by their coordinates (in_perturbed_circle).
/// So the same points give the same simplices, in whatever order they were added, deleted and taken
/// back.
///
/// Requires finite coordinates in the range of predicates.h throughout.
/// Cost: n log n for n points at once, whatever their order and place. A single change costs in
/// proportion to the vertices that come and go, after a walk from the hint, or from a signpost
/// where there is no hint. A search for the nearest point looks at all simplices of each point on
/// its way, which are thousands at a hub with thousands of neighbours.
/// Memory: 72 bytes a point in the plane and 255 in space (2 and 6.77 simplices a point), and 20
/// more while many are added at once.
/// Errors: std::length_error beyond 2^31 points or simplices, std::bad_alloc. After either, the
/// tessellation may only be destroyed, unless a History or a Trial takes back what was done.
/// Threads: queries may share a tessellation that nobody changes.
/// Audit: built with THIESSEN_AUDIT, as debug builds are, it is audited after every change, or as
/// often as keeps the cost in proportion to the changes. A finding is thrown as std::logic_error.
template <int Dimension>
class Tessellation {
 public:
  using Position = PositionIn<Dimension>;

  /// Adds points, and returns the number of each. Equal points share one number, and a point that
  /// is there already keeps the number that it has.
  std::vector<PointId> add_all(std::span<const Position> points);
  /// Adds one point and returns its number, which is the old one where the point is there already.
  /// `hint` is a point near it.
  PointId add(const Position& position, std::optional<PointId> hint = {});
  /// Deletes a point, whose number may then be given to another. Error: std::logic_error where the
  /// point is not there.
  void remove(PointId p);

  std::size_t count() const { return topology().count(); }
  bool empty() const { return count() == 0; }
  /// Whether the number belongs to a point of the tessellation. It does not if it was never given,
  /// is free again, or is the infinite point's.
  bool is_there(PointId p) const { return topology().is_there(p) && p != infinite_point; }
  const Position& position(PointId p) const { return structure_.position(p); }
  Span span() const { return static_cast<Span>(topology().dimension() + 1); }
  /// The table of simplices, those of the outside (with the infinite point) included.
  const Topology<Dimension>& topology() const { return structure_.topology(); }
  const Structure<Dimension>& structure() const { return structure_; }
  /// Calls `visit(p)` for every point of the tessellation, the infinite one excluded.
  template <typename Visit>
  void for_each_point(Visit&& visit) const;

  /// The number of the point at exactly this position, or nothing where there is none.
  std::optional<PointId> find(const Position& position, std::optional<PointId> hint = {}) const;
  /// The vertex whose simplex contains the position. Where the position is outside the hull, it is
  /// a vertex with the infinite point, whose facet of the hull is visible from there. Requires a
  /// span of at least a line, and that the position is on what the points span.
  VertexId locate(const Position& position, std::optional<PointId> hint = {}) const;
  /// Finds the vertices that a new point at the position would delete. Returns false where there is
  /// a point already. Requires the same as locate.
  bool find_conflict_zone(const Position& position, std::optional<PointId> hint,
                          ConflictZone<Dimension>& zone) const;

  /// The nearest point; of equally near ones the lexicographically first; nothing where there are
  /// no points. Cost: a walk from `hint`, or from a signpost.
  std::optional<PointId> nearest(const Position& to, std::optional<PointId> hint = {}) const;
  /// Finds the nearest point and all that are exactly as near; `nearest` stays empty where there
  /// are no points.
  void find_nearest(const Position& to, std::optional<PointId> hint,
                    std::vector<PointId>& nearest) const;

  /// Finds the vertices that p forms, and its neighbouring points. Requires a span of at least a
  /// line.
  void find_star(PointId p, Star<Dimension>& star) const;
  /// Calls `visit(neighbour)` for every finite Delaunay neighbour of p. Its cell shares a boundary
  /// with p's, or it is a neighbour only by the way in which a tie was broken. In the plane the
  /// order is counter-clockwise.
  template <typename Visit>
  void for_each_neighbour(PointId p, Visit&& visit) const;
  /// Calls `visit(neighbour)` for every finite Delaunay neighbour of p. This is the variant for
  /// many points in space: `star` keeps its lists from call to call.
  template <typename Visit>
  void for_each_neighbour(PointId p, Star<Dimension>& star, Visit&& visit) const;
  /// The points in lexicographic order. Requires a span of a line at most.
  std::vector<PointId> along_line() const;

  // The rest of the public part serves History and Trial, which record and undo changes.
  using Changes = typename Structure<Dimension>::Changes;
  /// The part of the tessellation's state that is saved as a whole, not change by change.
  struct Moment {
    typename Structure<Dimension>::State state;
    VertexId last = no_vertex;
  };
  /// Records in this list whatever is overwritten from now on; null ends the recording. Where
  /// changes are only tried, no signposts are put up, because they would outlive the trial.
  void record_in(Changes* changes, bool is_tried = false) {
    structure_.record_in(changes);
    is_tried_ = is_tried;
  }
  bool is_tried() const { return is_tried_ && structure_.recorded_in() != nullptr; }
  Moment moment() const { return {structure_.state(), last_}; }
  /// Undoes or redoes the changes between two extents, as Topology::exchange does. `then` is the
  /// moment on the other side of the changes.
  void exchange(Changes& changes, const typename Structure<Dimension>::Extent& first,
                const typename Structure<Dimension>::Extent& end, Moment& then, bool backward);
  /// Arranges the table as another of the same points is: see arrange_vertices().
  std::optional<std::size_t> arrange(std::span<const ArrangedVertex<Dimension>> vertices);
  /// Gives tests of the audit a structure that they can break.
  Structure<Dimension>& structure_to_break() { return structure_; }

 private:
  bool spans_all() const { return topology().dimension() == Dimension; }
  PointId insert(const Position& position, VertexId hint);
  VertexId start(const Position& position, std::optional<PointId> hint) const;
  VertexId standing(VertexId v) const;
  VertexId locate_from(VertexId hint, const Position& position) const;
  PointId corner_at(VertexId v, const Position& position) const;
  PointId walk_to_nearest(const Position& to, PointId from) const;
  void put_up_signposts(std::span<const PointId> sample);
  void renew_signposts(std::size_t points_each);
  void note_changes(std::size_t changes);

  Structure<Dimension> structure_;
  Insertion<Dimension> insertion_;
  Deletion<Dimension> deletion_;
  Signposts<Dimension> signposts_;
  VertexId last_ = no_vertex;  // a vertex at the last change, which may be gone by now
  bool is_tried_ = false;
  std::size_t changes_since_signposts_ = 0;
  std::size_t changes_since_audit_ = 0;
};

template <int Dimension>
template <typename Visit>
void Tessellation<Dimension>::for_each_point(Visit&& visit) const {
  for (std::uint32_t i = 1; i < topology().point_limit(); ++i) {
    if (topology().is_there(PointId{i})) visit(PointId{i});
  }
}

template <int Dimension>
template <typename Visit>
void Tessellation<Dimension>::for_each_neighbour(PointId p, Visit&& visit) const {
  Star<Dimension> star;
  for_each_neighbour(p, star, visit);
}

template <int Dimension>
template <typename Visit>
void Tessellation<Dimension>::for_each_neighbour(PointId p, Star<Dimension>& star,
                                                 Visit&& visit) const {
  if (topology().dimension() == 0) return;
  if (topology().dimension() == 2) {
    walk_round(topology(), p, [&](VertexId, PointId next, VertexId) {
      if (next != infinite_point) visit(next);
    });
    return;
  }
  find_star(p, star);
  for (const PointId q : star.points()) {
    if (q != infinite_point) visit(q);
  }
}

template <int Dimension>
void Tessellation<Dimension>::find_star(PointId p, Star<Dimension>& star) const {
  at_dimension<Dimension>(topology().dimension(),
                          [&](auto d) { star.template find<d>(topology(), p); });
}

}  // namespace thiessen
