#include <algorithm>

#include "tessellation/id_table.h"
#include "tessellation/tessellation.h"

namespace thiessen {

template <int Dimension>
std::optional<PointId> Tessellation<Dimension>::nearest(const Position& to,
                                                        std::optional<PointId> hint) const {
  std::vector<PointId> nearest;
  find_nearest(to, hint, nearest);
  if (nearest.empty()) return {};
  return *std::min_element(nearest.begin(), nearest.end(), [&](PointId a, PointId b) {
    return structure_.position(a) < structure_.position(b);
  });
}

template <int Dimension>
void Tessellation<Dimension>::find_nearest(const Position& to, std::optional<PointId> hint,
                                           std::vector<PointId>& nearest) const {
  nearest.clear();
  if (empty()) return;
  const auto corner_near = [&] {
    const VertexId v = structure_.finite_vertex(spans_all() ? locate(to) : start(to, {}));
    return topology().forming(v)[0];
  };
  const PointId best = walk_to_nearest(to, hint && is_there(*hint) ? *hint : corner_near());
  // Equally near points lie on one empty circle or sphere, along which Delaunay edges connect them,
  // so looking at neighbours finds them all.
  nearest.push_back(best);
  Star<Dimension> star;
  IdTable<1> known;
  for (std::size_t next = 0; next < nearest.size(); ++next) {
    for_each_neighbour(nearest[next], star, [&](PointId p) {
      if (compare_distance(to, position(p), position(best)) != 0) return;
      if (known.size() == 0) known.insert({static_cast<std::uint32_t>(best)}, 0);
      if (known.insert({static_cast<std::uint32_t>(p)}, 0).second) nearest.push_back(p);
    });
  }
}

// Walks from neighbour to nearer neighbour. The walk ends at the nearest point, because in a
// Delaunay tessellation only that has no nearer neighbour.
template <int Dimension>
PointId Tessellation<Dimension>::walk_to_nearest(const Position& to, PointId from) const {
  Star<Dimension> star;
  PointId best = from;
  for (bool moved = true; moved;) {
    moved = false;
    for_each_neighbour(best, star, [&](PointId p) {
      if (compare_distance(to, position(p), position(best)) >= 0) return;
      best = p;
      moved = true;
    });
  }
  return best;
}

#define THIESSEN_NEAREST(D)                                                                 \
  template std::optional<PointId> Tessellation<D>::nearest(const PositionIn<D>&,            \
                                                           std::optional<PointId>) const;   \
  template void Tessellation<D>::find_nearest(const PositionIn<D>&, std::optional<PointId>, \
                                              std::vector<PointId>&) const;                 \
  template PointId Tessellation<D>::walk_to_nearest(const PositionIn<D>&, PointId) const;

THIESSEN_NEAREST(2)
THIESSEN_NEAREST(3)

}  // namespace thiessen
