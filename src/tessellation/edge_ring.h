#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tessellation/topology.h"

namespace thiessen {

/// The vertices round an edge of the tessellation in space, and with it the face between two
/// cells: counter-clockwise as seen from the edge's end; points[i] and points[i + 1] form
/// vertices[i] with it.
struct EdgeRing {
  std::vector<PointId> points;
  std::vector<VertexId> vertices;
};

/// A vertex's forming points, even permutation of their order in the table: p, q, and the others.
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

/// The ring round p → q that begins at v, which both form.
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
