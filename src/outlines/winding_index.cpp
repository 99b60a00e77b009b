#include "outlines/winding_index.h"

#include <algorithm>
#include <utility>

#include "geometry/predicates.h"

namespace thiessen {

std::vector<WindingIndex::Edge> WindingIndex::edges_of(std::span<const Ring> rings) {
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring& ring = rings[r];
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges.push_back(
          {ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], static_cast<std::uint32_t>(r)});
  }
  return edges;
}

BoxTree WindingIndex::tree_of(std::span<const Edge> edges) {
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const Edge& edge : edges) boxes.push_back(box_of(edge.from, edge.to));
  return BoxTree(boxes);
}

WindingIndex::WindingIndex(std::span<const Ring> rings)
    : edges_(edges_of(rings)), tree_(tree_of(edges_)) {
  for (const Edge& edge : edges_) west_ = std::min({west_, edge.from.x, edge.to.x});
}

std::map<std::uint32_t, int> WindingIndex::at(Point p) const {
  std::map<std::uint32_t, int> windings;
  tree_.search(box_of({west_, p.y}, p), [&](std::uint32_t i) {
    const Edge& edge = edges_[i];
    if ((edge.from.y <= p.y) == (edge.to.y <= p.y)) return;
    const bool up = edge.to.y > edge.from.y;
    const int side = up ? orientation(edge.from, edge.to, p) : orientation(edge.to, edge.from, p);
    // The point has to lie to the east of the edge, which is to the right of an upward one. With
    // the interior of a ring to the left of its edges, its western side leads downwards.
    if (side < 0) windings[edge.ring] += up ? -1 : 1;
  });
  std::erase_if(windings, [](const auto& winding) { return winding.second == 0; });
  return windings;
}

}  // namespace thiessen
