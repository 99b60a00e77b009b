#include "outlines/winding_index.h"

#include "geometry/predicates.h"

namespace thiessen {

std::vector<WindingIndex::Edge> WindingIndex::RingEdges::edges_of(const Ring& ring) {
  std::vector<Edge> edges;
  edges.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
    edges.push_back({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]});
  return edges;
}

BoxTree WindingIndex::RingEdges::tree_of(std::span<const Edge> edges) {
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const Edge& edge : edges) boxes.push_back(box_of(edge.from, edge.to));
  return BoxTree(boxes);
}

WindingIndex::RingEdges::RingEdges(const Ring& ring)
    : edges_(edges_of(ring)), tree_(tree_of(edges_)) {
  for (const Point p : ring) box_.take_in(p);
}

int WindingIndex::RingEdges::winding_number(Point p) const {
  int number = 0;
  tree_.search({{box_.low.x, p.y}, p}, [&](std::uint32_t i) {
    const Edge& edge = edges_[i];
    if ((edge.from.y <= p.y) == (edge.to.y <= p.y)) return;
    const bool up = edge.to.y > edge.from.y;
    const int side = up ? orientation(edge.from, edge.to, p) : orientation(edge.to, edge.from, p);
    // The point has to lie to the east of the edge, which is to the right of an upward one. With
    // the interior of a ring to the left of its edges, its western side leads downwards.
    if (side < 0) number += up ? -1 : 1;
  });
  return number;
}

BoxTree WindingIndex::tree_of(std::span<const RingEdges> rings) {
  std::vector<Box> boxes;
  boxes.reserve(rings.size());
  for (const RingEdges& ring : rings) boxes.push_back(ring.box());
  return BoxTree(boxes);
}

WindingIndex::WindingIndex(std::span<const Ring> rings)
    : rings_(rings.begin(), rings.end()), tree_(tree_of(rings_)) {}

std::map<std::uint32_t, int> WindingIndex::at(Point p) const {
  std::map<std::uint32_t, int> windings;
  tree_.search({p, p}, [&](std::uint32_t ring) {
    const int number = rings_[ring].winding_number(p);
    if (number != 0) windings.emplace(ring, number);
  });
  return windings;
}

}  // namespace thiessen
