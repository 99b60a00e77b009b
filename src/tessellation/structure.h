#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "geometry/point.h"
#include "geometry/predicates.h"
#include "geometry/space_predicates.h"
#include "tessellation/topology.h"

namespace thiessen {

/// The topology, the positions of its points, and the decisions that depend on both. Where the
/// points span less than the space, decisions are made within what they span, that is, on their
/// line or plane. The template parameter `d` of the functions is the dimension that the points
/// span, topology().dimension(), known at compile time.
template <int Dimension>
class Structure {
 public:
  using Position = PositionIn<Dimension>;
  struct PositionChange {
    PointId point;
    Position position;
  };
  struct State {
    typename Topology<Dimension>::State topology;
    Axis dropped = Axis::x;
  };
  /// A place in the list of changes: how many of each kind come before it, as in Topology.
  struct Extent {
    typename Topology<Dimension>::Extent topology;
    std::size_t positions = 0;
  };
  struct Changes {
    typename Topology<Dimension>::Changes topology;
    std::vector<PositionChange> positions;

    Extent extent() const { return {topology.extent(), positions.size()}; }
    void erase(const Extent& first, const Extent& end) {
      topology.erase(first.topology, end.topology);
      positions.erase(positions.begin() + static_cast<std::ptrdiff_t>(first.positions),
                      positions.begin() + static_cast<std::ptrdiff_t>(end.positions));
    }
    void cut(const Extent& extent) { erase(extent, this->extent()); }
  };
  template <int d>
  using Simplex = std::array<PointId, static_cast<std::size_t>(d) + 1>;

  const Topology<Dimension>& topology() const { return topology_; }
  Topology<Dimension>& topology() { return topology_; }
  const Position& position(PointId p) const { return positions_[index(p)]; }

  /// Gives a number to a new point at `position`, which is no corner of a simplex yet.
  PointId add_point(const Position& position) {
    const PointId p = topology_.allocate_point();
    if (index(p) == positions_.size()) {
      positions_.push_back(position);
    }
    if (changes_.list != nullptr) changes_.list->positions.push_back({p, positions_[index(p)]});
    positions_[index(p)] = position;
    return p;
  }
  /// Prefetches what is stored of the point, because it will be needed soon.
  void fetch(PointId p) const {
    __builtin_prefetch(positions_.data() + index(p));
    topology_.fetch(p);
  }
  void fetch_position(PointId p) const { __builtin_prefetch(positions_.data() + index(p)); }
  void reserve(std::size_t points) {
    topology_.reserve(points);
    reserve_more(positions_, points);
  }

  /// The forming points of the vertex: the d + 1 corners that its row uses.
  template <int d>
  Simplex<d> simplex(VertexId v) const {
    Simplex<d> simplex;
    for (std::size_t i = 0; i <= d; ++i) simplex[i] = topology_.forming(v)[i];
    return simplex;
  }
  /// The corner of the simplex that is the infinite point, or d + 1 where there is none.
  template <int d>
  static std::size_t infinite_corner(const Simplex<d>& simplex) {
    std::size_t i = 0;
    while (i <= d && simplex[i] != infinite_point) ++i;
    return i;
  }

  /// The orientation of the simplex with its corner `replaced` moved to q: 1 as it should be, -1
  /// turned over, 0 flat. Requires that the other corners are finite.
  template <int d>
  int orientation_with(const Simplex<d>& simplex, std::size_t replaced, const Position& q) const {
    const auto at = [&](std::size_t i) -> const Position& {
      return i == replaced ? q : position(simplex[i]);
    };
    if constexpr (d == 1) {
      return at(0) < at(1) ? 1 : at(1) < at(0) ? -1 : 0;
    } else if constexpr (d == Dimension && d == 2) {
      return orientation(at(0), at(1), at(2));
    } else if constexpr (d == 3) {
      return orientation(at(0), at(1), at(2), at(3));
    } else {
      return orientation_in_plane(dropped_, at(0), at(1), at(2));
    }
  }
  /// The orientation of a finite simplex: 1 as it should be, -1 turned over, 0 flat.
  template <int d>
  int orientation_of(const Simplex<d>& simplex) const {
    return orientation_with<d>(simplex, 0, position(simplex[0]));
  }

  /// Whether q is in conflict with the simplex, that is, would delete its vertex: q is inside the
  /// circumscribed circle or sphere, and so nearer to the vertex than the forming points are. Where
  /// one corner is infinite, q is in conflict if it lies beyond the facet of the hull, or on the
  /// facet's plane and inside its circumscribed circle. Ties are broken by perturbation. Requires
  /// that q is none of the corners, and orientation_of(simplex) > 0 where the simplex is finite.
  template <int d>
  bool in_conflict(const Simplex<d>& simplex, const Position& q) const {
    const std::size_t infinite = infinite_corner<d>(simplex);
    if (infinite > d) return in_sphere_of<d>(simplex, q);
    const int side = orientation_with<d>(simplex, infinite, q);
    return side != 0 ? side > 0 : in_facet_sphere<d>(simplex, infinite, q);
  }

  /// Whether q lies off what the points span, so that it would raise the dimension. Requires at
  /// least one point.
  bool is_off(const Position& q) const {
    const VertexId v = finite_vertex();
    const auto& f = topology_.forming(v);
    switch (topology_.dimension()) {
      case 0:
        return q != position(f[0]);
      case 1:
        return orientation_off_line(f[0], f[1], q) != 0;
      case 2:
        if constexpr (Dimension == 3) {
          return orientation(position(f[0]), position(f[1]), position(f[2]), q) != 0;
        }
    }
    return false;
  }
  /// The coordinate that is dropped to project the points' plane. It matters only for points in
  /// space that span a plane.
  Axis dropped() const { return dropped_; }
  void set_dropped(Axis dropped) { dropped_ = dropped; }

  /// A finite vertex (one without the infinite point) at or next to `hint`. Requires at least one
  /// point.
  VertexId finite_vertex(VertexId hint) const {
    const std::size_t infinite = topology_.corner_of(hint, infinite_point);
    return infinite == Topology<Dimension>::corners ? hint : topology_.neighbour(hint, infinite);
  }
  VertexId finite_vertex() const { return finite_vertex(topology_.vertex_of(infinite_point)); }

  void record_in(Changes* changes) {
    changes_.list = changes;
    topology_.record_in(changes == nullptr ? nullptr : &changes->topology);
  }
  Changes* recorded_in() const { return changes_.list; }
  State state() const { return {topology_.state(), dropped_}; }
  /// Undoes or redoes the changes between two extents, as Topology::exchange does, positions
  /// included.
  void exchange(Changes& changes, const Extent& first, const Extent& end, State& then,
                bool backward) {
    positions_.resize(std::max<std::size_t>(positions_.size(), then.topology.points));
    const auto swap_position = [&](std::size_t i) {
      std::swap(changes.positions[i].position, positions_[index(changes.positions[i].point)]);
    };
    if (backward) {
      for (std::size_t i = end.positions; i > first.positions; --i) swap_position(i - 1);
    } else {
      for (std::size_t i = first.positions; i < end.positions; ++i) swap_position(i);
    }
    topology_.exchange(changes.topology, first.topology, end.topology, then.topology, backward);
    std::swap(dropped_, then.dropped);
    positions_.resize(topology_.point_limit());
  }

 private:
  // The result is 0 where the three points are on one line, and not 0 elsewhere.
  int orientation_off_line(PointId a, PointId b, const Position& q) const {
    if constexpr (Dimension == 2) {
      return orientation(position(a), position(b), q);
    } else {
      return are_collinear(position(a), position(b), q) ? 0 : 1;
    }
  }

  template <int d>
  bool in_sphere_of(const Simplex<d>& simplex, const Position& q) const {
    const auto at = [&](std::size_t i) -> const Position& { return position(simplex[i]); };
    if constexpr (d == 1) {
      return std::min(at(0), at(1)) < q && q < std::max(at(0), at(1));
    } else if constexpr (d == Dimension && d == 2) {
      return in_perturbed_circle(at(0), at(1), at(2), q);
    } else if constexpr (d == 3) {
      return in_perturbed_sphere(at(0), at(1), at(2), at(3), q);
    } else {
      return in_perturbed_circle_in_plane(dropped_, at(0), at(1), at(2), q);
    }
  }

  // Decides in_conflict for a facet of the hull where q is on the facet's own line or plane.
  template <int d>
  bool in_facet_sphere(const Simplex<d>& simplex, std::size_t infinite, const Position& q) const {
    const auto at = [&](std::size_t i) -> const Position& {
      return position(simplex[i < infinite ? i : i + 1]);
    };
    if constexpr (d == 1) {
      return false;
    } else if constexpr (d == 2) {
      return std::min(at(0), at(1)) < q && q < std::max(at(0), at(1));
    } else {
      const Axis dropped = projection_axis(at(0), at(1), at(2));
      return orientation_in_plane(dropped, at(0), at(1), at(2)) > 0
                 ? in_perturbed_circle_in_plane(dropped, at(0), at(1), at(2), q)
                 : in_perturbed_circle_in_plane(dropped, at(1), at(0), at(2), q);
    }
  }

  Topology<Dimension> topology_;
  // The infinite point has the first position, which is never used.
  std::vector<Position> positions_ = std::vector<Position>(1);
  Axis dropped_ = Axis::x;
  Recorded<Changes> changes_;
};

}  // namespace thiessen
