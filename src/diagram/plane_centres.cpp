#include "diagram/plane_centres.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/predicates.h"

namespace thiessen {

PlaneCentres::PlaneCentres(const Tessellation<2>& tessellation)
    : tessellation_(tessellation), topology_(tessellation.topology()), groups_(topology_.size()) {
  constexpr double indistinct = 4;
  unite([this](VertexId v, VertexId w) { return are_cocircular(v, w); });
  compute();
  const bool any_indistinct = unite([this](VertexId v, VertexId w) {
    const Point p = centre_[index(v)];
    const Point q = centre_[index(w)];
    const double allowed = indistinct * (rounding(v) + rounding(w));
    return std::max(std::abs(q.x - p.x), std::abs(q.y - p.y)) <= allowed;
  });
  if (any_indistinct) compute();
}

// Returns whether any were united.
template <typename AreOne>
bool PlaneCentres::unite(AreOne&& are_one) {
  bool any = false;
  topology_.for_each_vertex([&](VertexId v) {
    if (topology_.is_infinite(v)) return;
    for (std::size_t side = 0; side < 3; ++side) {
      const VertexId w = topology_.neighbour(v, side);
      if (w < v || topology_.is_infinite(w) || !are_one(v, w)) continue;
      groups_.unite(groups_.find(index(v)), groups_.find(index(w)));
      any = true;
    }
  });
  return any;
}

// Computes the centre of each group from its lexicographically first simplex, so that it does not
// depend on the order in which the places came.
void PlaneCentres::compute() {
  std::vector<VertexId> first(topology_.size(), no_vertex);
  const auto for_each_simplex = [&](auto&& visit) {
    topology_.for_each_vertex([&](VertexId v) {
      if (!topology_.is_infinite(v)) visit(v);
    });
  };
  for_each_simplex([&](VertexId v) {
    VertexId& best = first[group_of(v)];
    if (best == no_vertex || corners_of(v) < corners_of(best)) best = v;
  });
  centre_.resize(topology_.size());
  for_each_simplex([&](VertexId v) {
    if (first[group_of(v)] == v) centre_[index(v)] = centre_of(v);
  });
  for_each_simplex([&](VertexId v) { centre_[index(v)] = centre_[index(first[group_of(v)])]; });
}

Point PlaneCentres::centre_of(VertexId v) const {
  const auto& f = topology_.forming(v);
  return circumcentre(position(f[0]), position(f[1]), position(f[2]));
}

bool PlaneCentres::are_cocircular(VertexId v, VertexId w) const {
  const auto& f = topology_.forming(v);
  const PointId across = topology_.forming(w)[topology_.side_towards(w, v)];
  return in_circle(position(f[0]), position(f[1]), position(f[2]), position(across)) == 0;
}

// How far a computed centre may be from the true one: see circumcentre.
double PlaneCentres::rounding(VertexId v) const {
  const Point centre = centre_[index(v)];
  const Point corner = position(topology_.forming(v)[0]);
  return 0x1p-47 * (std::abs(centre.x - corner.x) + std::abs(centre.y - corner.y)) +
         0x1p-52 * std::max(std::abs(centre.x), std::abs(centre.y));
}

std::array<Point, 3> PlaneCentres::corners_of(VertexId v) const {
  const auto& f = topology_.forming(v);
  std::array<Point, 3> corners{position(f[0]), position(f[1]), position(f[2])};
  std::sort(corners.begin(), corners.end());
  return corners;
}

}  // namespace thiessen
