#include "tessellation/coinciding_vertices.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "base/interrupt.h"
#include "geometry/space_predicates.h"

namespace thiessen {

CoincidingVertices::CoincidingVertices(const Tessellation<3>& tessellation, const Star<3>& star,
                                       PointId p)
    : tessellation_(tessellation), star_(star), same_as_(star.vertices().size()) {
  for (const VertexId v : star.vertices())
    place_.insert({static_cast<std::uint32_t>(v)}, static_cast<std::uint32_t>(place_.size()));
  std::iota(same_as_.begin(), same_as_.end(), std::size_t{0});
  unite_spheres(p);
  unite_circles(p);
  find_first();
}

std::size_t CoincidingVertices::group_of(VertexId v) const {
  std::size_t place = *place_.find({static_cast<std::uint32_t>(v)});
  while (same_as_[place] != place) place = same_as_[place] = same_as_[same_as_[place]];
  return place;
}

VertexId CoincidingVertices::inside(VertexId v) const {
  const auto& topology = tessellation_.topology();
  return topology.neighbour(v, topology.corner_of(v, infinite_point));
}

void CoincidingVertices::unite(VertexId v, VertexId w) {
  same_as_[group_of(w)] = group_of(v);
}

// Calls `visit(v, w, across)` once for each pair of neighbouring vertices that p both forms;
// `across` is the forming point of w that v does not have.
template <typename Visit>
void CoincidingVertices::for_each_pair(PointId p, Visit visit) const {
  const auto& topology = tessellation_.topology();
  for (const VertexId v : star_.vertices()) {
    throw_if_interrupted();
    for (std::size_t side = 0; side < 4; ++side) {
      const VertexId w = topology.neighbour(v, side);
      if (topology.forming(v)[side] == p || index(w) < index(v)) continue;
      visit(v, w, topology.forming(w)[topology.side_towards(w, v)]);
    }
  }
}

// Comparing neighbours suffices, because simplices of one sphere that have p are connected through
// facets that have p.
void CoincidingVertices::unite_spheres(PointId p) {
  const auto& topology = tessellation_.topology();
  for_each_pair(p, [&](VertexId v, VertexId w, PointId across) {
    if (topology.is_infinite(v) || topology.is_infinite(w)) return;
    const auto at = [&](std::size_t i) -> const SpacePoint& {
      return tessellation_.position(topology.forming(v)[i]);
    };
    if (in_sphere(at(0), at(1), at(2), at(3), tessellation_.position(across)) == 0) unite(v, w);
  });
}

void CoincidingVertices::unite_circles(PointId p) {
  const auto& topology = tessellation_.topology();
  for_each_pair(p, [&](VertexId v, VertexId w, PointId across) {
    if (!topology.is_infinite(v) || !topology.is_infinite(w)) return;
    if (!coincide(inside(v), inside(w))) return;
    const int side = tessellation_.structure().orientation_with<3>(
        topology.forming(v), topology.corner_of(v, infinite_point), tessellation_.position(across));
    if (side == 0) unite(v, w);
  });
}

void CoincidingVertices::find_first() {
  first_.assign(star_.vertices().size(), no_vertex);
  for (const VertexId v : star_.vertices()) {
    throw_if_interrupted();
    VertexId& first = first_[group_of(v)];
    if (first == no_vertex || in_order(tessellation_, v) < in_order(tessellation_, first))
      first = v;
  }
}

std::array<SpacePoint, 4> in_order(const Tessellation<3>& tessellation, VertexId v) {
  std::array<SpacePoint, 4> positions;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const PointId p = tessellation.topology().forming(v)[i];
    positions[i] = p == infinite_point ? SpacePoint{} : tessellation.position(p);
  }
  std::sort(positions.begin(), positions.end());
  return positions;
}

}  // namespace thiessen
