#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/point.h"
#include "geometry/signposts.h"
#include "tessellation/at_dimension.h"
#include "tessellation/conflict_zone.h"
#include "tessellation/deletion.h"
#include "tessellation/insertion.h"
#include "tessellation/star.h"
#include "tessellation/structure.h"
#include "tessellation/topology.h"

namespace thiessen {

/// What the points span.
enum class Span { nothing, point, line, plane, space };

/// The Voronoi and Delaunay tessellations of points in the plane or in space, changed point by
/// point, by insertion and by deletion (J. C.-H. Chang, Construction of the Voronoi and Delaunay
/// tessellations, 1982). There is no initial simplex: a point at infinity closes the hull, and what
/// the points span is explicit; where they span less than the space, the tessellation is that of
/// their line or plane. Degenerate positions are no special case: every decision is exact, and
/// points on one circle or sphere are told apart by their coordinates (in_perturbed_circle), so the
/// same points give the same simplices in whatever order they were added, deleted and taken back.
///
/// Coordinates must be finite and in the range of predicates.h throughout.
/// Cost: n log n for n points at once, whatever their order and place; a change is in proportion to
/// the vertices that come and go, after a walk from the hint, or from a signpost where there is no
/// hint; the simplices of points on a walk are looked at all, thousands at a hub with thousands of
/// neighbours. Memory: 72 bytes a point in the plane, 255 in space (2 and 6.77 simplices a point),
/// and 20 more while many are added at once.
/// Errors: std::length_error beyond 2^31 points or simplices, std::bad_alloc: afterwards it is fit
/// for destruction only, but in a History or a Trial, which take back what was done.
/// Threads: queries may share a tessellation that nobody changes.
/// Built with THIESSEN_AUDIT, as debug builds are, it is audited after every change, or as often as
/// keeps that in proportion to the changes; what is found is a std::logic_error.
template <int Dimension>
class Tessellation {
 public:
  using Position = PositionIn<Dimension>;

  /// Adds points; equal ones, and those that are there already, get one number. Returns for each
  /// point its number.
  std::vector<PointId> add_all(std::span<const Position> points);
  /// Adds one point, or finds its number where it is there already. `hint`: a point near it.
  PointId add(const Position& position, std::optional<PointId> hint = {});
  /// Deletes a point. Its number will be given again. Error: std::logic_error where it is not
  /// there.
  void remove(PointId p);

  std::size_t count() const { return topology().count(); }
  bool empty() const { return count() == 0; }
  /// Of a number below topology().point_limit(), other than the infinite point's.
  bool is_there(PointId p) const { return topology().is_there(p) && p != infinite_point; }
  const Position& position(PointId p) const { return structure_.position(p); }
  Span span() const { return static_cast<Span>(topology().dimension() + 1); }
  /// The simplices, those of the outside (with the infinite point) among them, as in Topology.
  const Topology<Dimension>& topology() const { return structure_.topology(); }
  const Structure<Dimension>& structure() const { return structure_; }
  /// Calls `visit(p)` for every point that is there.
  template <typename Visit>
  void for_each_point(Visit&& visit) const;

  /// The number of the point at this very position.
  std::optional<PointId> find(const Position& position, std::optional<PointId> hint = {}) const;
  /// The vertex whose simplex holds the position, or where that is off the hull, one with the
  /// infinite point whose facet it sees. Requires a span of at least a line, and the position on
  /// what the points span.
  VertexId locate(const Position& position, std::optional<PointId> hint = {}) const;
  /// What would be deleted if a point came there; none where there is one already. Requires what
  /// locate requires.
  bool find_conflict_zone(const Position& position, std::optional<PointId> hint,
                          ConflictZone<Dimension>& zone) const;

  /// The nearest point, the lexicographically first of equally near ones; none where there are no
  /// points. Cost: a walk from `hint`, or from a signpost.
  std::optional<PointId> nearest(const Position& to, std::optional<PointId> hint = {}) const;
  /// The nearest point and all that are as near, exactly; nothing where there are no points.
  void find_nearest(const Position& to, std::optional<PointId> hint,
                    std::vector<PointId>& nearest) const;

  /// The vertices that p forms, and its neighbours. Requires a span of at least a line.
  void find_star(PointId p, Star<Dimension>& star) const;
  /// Calls `visit(neighbour)` for every point whose cell has a boundary in common with p's, or
  /// would have but for a tie; never the infinite one. In the plane counter-clockwise.
  template <typename Visit>
  void for_each_neighbour(PointId p, Visit&& visit) const;
  /// The same, for many points in space: `star` keeps its lists.
  template <typename Visit>
  void for_each_neighbour(PointId p, Star<Dimension>& star, Visit&& visit) const;
  /// The points in lexicographic order. Requires a span of a line at most.
  std::vector<PointId> along_line() const;

  // For History and Trial.
  using Changes = typename Structure<Dimension>::Changes;
  struct Moment {
    typename Structure<Dimension>::State state;
    VertexId last = no_vertex;
  };
  /// Keeps what is overwritten from now on; nothing for null. Where it is only tried, walks leave
  /// no signposts behind.
  void record_in(Changes* changes, bool is_tried = false) {
    structure_.record_in(changes);
    is_tried_ = is_tried;
  }
  bool is_tried() const { return is_tried_ && structure_.recorded_in() != nullptr; }
  Moment moment() const { return {structure_.state(), last_}; }
  /// Takes the changes between two extents back, `then` being the moment before them, or makes them
  /// again: see Topology.
  void exchange(Changes& changes, const typename Structure<Dimension>::Extent& first,
                const typename Structure<Dimension>::Extent& end, Moment& then, bool backward);
  /// For tests of audit: to break it.
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
  VertexId last_ = no_vertex;  // where the last change was; it may be gone
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
