#include "earth/cells/cell_mesh.h"

#include <algorithm>
#include <cstddef>

namespace thiessen {

CellMesh::CellMesh(const SphereTessellation& sphere) {
  if (sphere.tessellation().span() == Span::plane) {
    take_over(sphere);
  } else {
    add_fans(sphere);
  }
}

void CellMesh::take_over(const SphereTessellation& sphere) {
  const Topology<2>& topology = sphere.tessellation().topology();
  corners_.resize(3 * topology.size());
  twin_.resize(corners_.size());
  std::vector<std::uint32_t> number(topology.size());
  std::uint32_t triangles = 0;
  topology.for_each_vertex([&](VertexId v) { number[index(v)] = triangles++; });
  corners_.resize(std::size_t{3} * triangles);
  twin_.resize(corners_.size());
  topology.for_each_vertex([&](VertexId v) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const VertexId w = topology.neighbour(v, i);
      const SideIndex s = side(number[index(v)], i);
      corners_[index(s)] = sphere.place(topology.forming(v)[i]);
      twin_[index(s)] =
          side(number[index(w)], static_cast<std::uint32_t>(topology.side_towards(w, v)));
    }
  });
}

// The places on the circle are numbered 0 to k - 1; one fan runs round the circle on one side of
// it, and the other fan runs back on the other side.
void CellMesh::add_fans(const SphereTessellation& sphere) {
  std::vector<PlaceIndex> ring;
  for (const PointId p : sphere.tessellation().along_line()) ring.push_back(sphere.place(p));
  ring.push_back(sphere.pole());
  const auto fans = static_cast<std::uint32_t>(ring.size() - 2);
  twin_.resize(std::size_t{6} * fans);
  for (std::uint32_t i = 0; i < fans; ++i) {
    for (const PlaceIndex p : {ring[0], ring[i + 1], ring[i + 2]}) corners_.push_back(p);
  }
  for (std::uint32_t i = 0; i < fans; ++i) {
    for (const PlaceIndex p : {ring[0], ring[i + 2], ring[i + 1]}) corners_.push_back(p);
  }
  for (std::uint32_t i = 0; i < fans; ++i) {
    join(side(i, 0), side(fans + i, 0));
    if (i + 1 < fans) {
      join(side(i, 1), side(i + 1, 2));
      join(side(fans + i, 2), side(fans + i + 1, 1));
    }
  }
  join(side(0, 2), side(fans, 1));
  join(side(fans - 1, 1), side(2 * fans - 1, 2));
}

void CellMesh::set_corners(std::uint32_t triangle, const std::array<PlaceIndex, 3>& corners) {
  std::copy(corners.begin(), corners.end(), corners_.begin() + std::ptrdiff_t{3} * triangle);
}

void CellMesh::join(SideIndex a, SideIndex b) {
  twin_[index(a)] = b;
  twin_[index(b)] = a;
}

void CellMesh::flip(SideIndex s) {
  const SideIndex t = twin(s);
  const SideIndex after_s = twin(next(s));
  const SideIndex before_s = twin(previous(s));
  const SideIndex after_t = twin(next(t));
  const SideIndex before_t = twin(previous(t));
  const PlaceIndex a = apex(s), b = from(s), c = to(s), d = apex(t);
  // The new triangles are a, b, d and a, d, c, both beginning at a.
  const SideIndex across_a = s, across_b = next(s), across_d = previous(s);
  const SideIndex across_a2 = t, across_d2 = next(t), across_c = previous(t);
  corners_[index(across_a)] = a;
  corners_[index(across_b)] = b;
  corners_[index(across_d)] = d;
  corners_[index(across_a2)] = a;
  corners_[index(across_d2)] = d;
  corners_[index(across_c)] = c;
  join(across_d2, after_s);
  join(across_d, before_s);
  join(across_a, after_t);
  join(across_a2, before_t);
  join(across_b, across_c);
}

}  // namespace thiessen
