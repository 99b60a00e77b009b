#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tessellation/topology.h"

namespace thiessen {

/// The ring of vertices round a Delaunay edge in space, which is also the Voronoi face between two
/// cells. It is counter-clockwise as seen from the edge's end: points[i] and points[i + 1] form
/// vertices[i] with the edge.
struct EdgeRing {
  std::vector<PointId> points;
  std::vector<VertexId> vertices;
};

/// The vertex's forming points, reordered so that p and q come first. It is an even permutation of
/// their order in the table, so the orientation stays the same.
inline Topology<3>::Forming turned_to(const Topology<3>& topology, VertexId v, PointId p,
                                      PointId q) {
  const auto& forming = topology.forming(v);
  const std::size_t i = topology.corner_of(v, p);
  const std::size_t j = topology.corner_of(v, q);
  std::size_t k = 0;
  while (k == i || k == j) ++k;
  const std::size_t l = 6 - i - j - k;
  const bool odd = (i > j) ^ (i > k) ^ (i > l) ^ (j > k) ^ (j > l);  // k < l
  return {p, q, forming[odd ? l : k], forming[odd ? k : l]};
}

/// Finds the ring round the edge p → q, beginning at the vertex v. Requires that both p and q form
/// v.
inline EdgeRing ring_round(const Topology<3>& topology, PointId p, PointId q, VertexId v) {
  EdgeRing ring;
  const VertexId first = v;
  do {
    const PointId next = turned_to(topology, v, p, q)[2];
    ring.points.push_back(next);
    ring.vertices.push_back(v);
    v = topology.neighbour(v, topology.corner_of(v, next));
  } while (v != first);
  return ring;
}

}  // namespace thiessen
