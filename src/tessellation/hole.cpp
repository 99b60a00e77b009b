#include "tessellation/hole.h"

#include <algorithm>
#include <utility>

#include "base/interrupt.h"
#include "tessellation/parity.h"
#include "tessellation/tessellation.h"

namespace thiessen {

template <int Dimension>
typename Hole<Dimension>::Key Hole<Dimension>::key_of(const Forming& forming, std::size_t side) {
  Key key;
  std::size_t n = 0;
  for (std::size_t i = 0; i < forming.size(); ++i) {
    if (i != side) key[n++] = static_cast<std::uint32_t>(forming[i]);
  }
  std::sort(key.begin(), key.end());
  return key;
}

template <int Dimension>
template <int d>
void Hole<Dimension>::open(const Topology<Dimension>& topology, PointId p,
                           const Star<Dimension>& star) {
  star_ = &star;
  reused_ = 0;
  facets_.clear();
  facet_of_.clear();
  new_vertices_.clear();
  for (const VertexId v : star.vertices()) {
    throw_if_interrupted();
    const std::size_t side = topology.corner_of(v, p);
    const VertexId outside = topology.neighbour(v, side);
    facet_of_.insert(key_of(topology.forming(v), side), static_cast<std::uint32_t>(facets_.size()));
    facets_.push_back({topology.forming(v), side, outside, topology.side_towards(outside, v)});
  }
}

template <int Dimension>
template <int d>
const std::vector<VertexId>& Hole<Dimension>::fill(Structure<Dimension>& structure) {
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    if (facets_[i].outside == no_vertex) continue;
    Forming forming = facets_[i].forming;
    forming[facets_[i].side] = apex_of<d>(structure, facets_[i]);
    add_simplex<d>(structure.topology(), forming);
  }
  return finish(structure.topology());
}

// Step 3 of deletion: finds the point of the star that completes the facet to a simplex.
template <int Dimension>
template <int d>
PointId Hole<Dimension>::apex_of(const Structure<Dimension>& structure, const Facet& facet) const {
  typename Structure<Dimension>::template Simplex<d> simplex;
  std::copy_n(facet.forming.begin(), d + 1, simplex.begin());
  PointId best = infinite_point;
  for (const PointId p : star_->points()) {
    if (p == infinite_point || !may_complete<d>(structure, facet, p)) continue;
    simplex[facet.side] = best;
    if (best == infinite_point ||
        structure.template in_conflict<d>(simplex, structure.position(p))) {
      best = p;
    }
  }
  return best;
}

// Whether p may complete the facet: it is none of the facet's points, and is on the hole's side of
// it. A facet with the infinite point stands upright on the hull. All points are on its inner side
// but those of the hull's facet beyond it, and those in the plane of that facet that are on the
// facet's side.
template <int Dimension>
template <int d>
bool Hole<Dimension>::may_complete(const Structure<Dimension>& structure, const Facet& facet,
                                   PointId p) const {
  typename Structure<Dimension>::template Simplex<d> simplex;
  std::copy_n(facet.forming.begin(), d + 1, simplex.begin());
  simplex[facet.side] = p;
  for (std::size_t i = 0; i <= d; ++i) {
    if (i != facet.side && simplex[i] == p) return false;
  }
  const auto& position = structure.position(p);
  const std::size_t infinite = Structure<Dimension>::template infinite_corner<d>(simplex);
  if (infinite > d)
    return structure.template orientation_with<d>(simplex, facet.side, position) > 0;
  const PointId beyond = structure.topology().forming(facet.outside)[facet.outside_side];
  if (p == beyond) return false;
  if constexpr (d == 3) {
    simplex[infinite] = beyond;
    if (structure.template orientation_with<d>(simplex, facet.side, position) != 0) return true;
    const auto at = [&](std::size_t i) -> const auto& {
      return structure.position(simplex[i]);
    };
    const std::size_t a =
        (infinite + 1) % 4 == facet.side ? (infinite + 2) % 4 : (infinite + 1) % 4;
    const std::size_t b = 6 - infinite - facet.side - a;
    const Axis dropped = projection_axis(at(a), at(b), at(infinite));
    return orientation_in_plane(dropped, at(a), at(b), position) ==
           -orientation_in_plane(dropped, at(a), at(b), at(infinite));
  }
  return true;
}

template <int Dimension>
template <int d>
void Hole<Dimension>::add_simplex(Topology<Dimension>& topology, const Forming& forming) {
  throw_if_interrupted();
  const VertexId v = next_vertex(topology);
  auto& row = topology.fill(v);
  row.forming = forming;
  row.neighbours.fill(no_vertex);
  for (std::size_t i = 0; i <= d; ++i) topology.set_vertex_of(forming[i], v);
  for (std::size_t i = 0; i <= d; ++i) {
    Facet facet{forming, i == 0 ? 1u : 0u, v, i};
    std::swap(facet.forming[i], facet.forming[facet.side]);
    meet(topology, facet);
  }
}

// Steps 4 and 5 of deletion: a facet that meets its twin has a vertex on either side, and so is
// closed.
template <int Dimension>
void Hole<Dimension>::meet(Topology<Dimension>& topology, const Facet& facet) {
  const auto [found, is_new] = facet_of_.insert(key_of(facet.forming, facet.side),
                                                static_cast<std::uint32_t>(facets_.size()));
  if (is_new) {
    facets_.push_back(facet);
    return;
  }
  Facet& other = facets_[*found];
  topology.fill(facet.outside).neighbours[facet.outside_side] = other.outside;
  topology.change(other.outside).neighbours[other.outside_side] = facet.outside;
  other.outside = no_vertex;
}

template <int Dimension>
VertexId Hole<Dimension>::next_vertex(Topology<Dimension>& topology) {
  VertexId v;
  if (reused_ < star_->vertices().size()) {
    v = star_->vertices()[reused_++];
    topology.change(v);
  } else {
    v = topology.allocate();
  }
  new_vertices_.push_back(v);
  return v;
}

template <int Dimension>
const std::vector<VertexId>& Hole<Dimension>::finish(Topology<Dimension>& topology) {
  while (reused_ < star_->vertices().size()) topology.release(star_->vertices()[reused_++]);
  return new_vertices_;
}

template <int Dimension>
template <int d>
const std::vector<VertexId>& Hole<Dimension>::fill_from_tessellation(
    Structure<Dimension>& structure) {
  std::vector<PositionIn<Dimension>> positions;
  std::vector<PointId> points;
  for (const PointId p : star_->points()) {
    if (p == infinite_point) continue;
    positions.push_back(structure.position(p));
    points.push_back(p);
  }
  Tessellation<Dimension> round;
  const std::vector<PointId> numbers = round.add_all(positions);
  const Topology<Dimension>& there = round.topology();
  if (there.dimension() < d) {  // the points round p all lie on one line or plane of the hull
    const std::size_t rim = facets_.size();
    for (std::size_t i = 0; i < rim; ++i) {
      Forming forming = facets_[i].forming;
      forming[facets_[i].side] = infinite_point;
      const bool finite = std::count(forming.begin(), forming.end(), infinite_point) == 1;
      if (finite) add_simplex<d>(structure.topology(), forming);
    }
    return finish(structure.topology());
  }
  std::vector<PointId> ours(there.point_limit(), infinite_point);
  for (std::size_t i = 0; i < numbers.size(); ++i) ours[index(numbers[i])] = points[i];
  const auto our_forming = [&](VertexId v) {
    Forming forming = there.forming(v);
    for (std::size_t i = 0; i <= d; ++i) forming[i] = ours[index(forming[i])];
    return forming;
  };
  const auto rim_facet = [&](const Forming& forming, std::size_t side) -> const Facet* {
    const std::uint32_t* found = facet_of_.find(key_of(forming, side));
    return found == nullptr ? nullptr : &facets_[*found];
  };

  std::vector<bool> is_within(there.size(), false);
  std::vector<VertexId> within;
  const auto take = [&](VertexId v) {
    if (is_within[index(v)]) return;
    is_within[index(v)] = true;
    within.push_back(v);
  };
  there.for_each_vertex([&](VertexId v) {
    throw_if_interrupted();
    const Forming forming = our_forming(v);
    for (std::size_t side = 0; side <= d; ++side) {
      const Facet* facet = rim_facet(forming, side);
      if (facet != nullptr && is_inside<d>(*facet, forming, side)) take(v);
    }
  });
  for (std::size_t next = 0; next < within.size(); ++next) {
    throw_if_interrupted();
    const Forming forming = our_forming(within[next]);
    for (std::size_t side = 0; side <= d; ++side) {
      if (rim_facet(forming, side) == nullptr) take(there.neighbour(within[next], side));
    }
  }
  for (const VertexId v : within) add_simplex<d>(structure.topology(), our_forming(v));
  return finish(structure.topology());
}

// Whether a simplex lies in the hole and not beyond its rim. Requires that it has the facet's
// points, across from its corner `side`.
template <int Dimension>
template <int d>
bool Hole<Dimension>::is_inside(const Facet& facet, const Forming& forming,
                                std::size_t side) const {
  Forming completed = facet.forming;
  completed[facet.side] = forming[side];
  return parity(completed, forming, d + 1) == Parity::even;
}

#define THIESSEN_HOLE(D, d)                                                    \
  template void Hole<D>::open<d>(const Topology<D>&, PointId, const Star<D>&); \
  template const std::vector<VertexId>& Hole<D>::fill<d>(Structure<D>&);       \
  template const std::vector<VertexId>& Hole<D>::fill_from_tessellation<d>(Structure<D>&);

THIESSEN_HOLE(2, 1)
THIESSEN_HOLE(2, 2)
THIESSEN_HOLE(3, 1)
THIESSEN_HOLE(3, 2)
THIESSEN_HOLE(3, 3)

}  // namespace thiessen
