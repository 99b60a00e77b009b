#include "earth/geodesic_vertices.h"

#include <algorithm>

#include "base/parallel.h"
#include "earth/edge_drawing.h"
#include "earth/geodesic.h"
#include "geometry/disjoint_sets.h"

namespace thiessen {
namespace {

// How much nearer, in metres, a point must be to a vertex to be within its circle: more than the
// noise of distances.
constexpr double within_circle = 2e-7;
// Radians: 2 micrometres.
constexpr double indistinct = 3e-13;

}  // namespace

GeodesicVertices::GeodesicVertices(const SphereTessellation& sphere, std::span<const Point> places,
                                   const Box& frame, unsigned threads)
    : sphere_(sphere), places_(places), mesh_(sphere), vertices_(mesh_.triangles()) {
  for (std::uint32_t t = 0; t < mesh_.triangles(); ++t) place_on_sphere(t);
  find_near(frame);
  constexpr std::size_t some = 256;
  in_parallel((vertices_.size() + some - 1) / some, threads, [&](std::size_t, std::size_t piece) {
    const std::size_t end = std::min(vertices_.size(), (piece + 1) * some);
    for (std::size_t t = piece * some; t < end; ++t) {
      if (vertices_[t].is_near) place_on_earth(static_cast<std::uint32_t>(t));
    }
  });
  flip_sides();
  unite();
}

void GeodesicVertices::place_on_sphere(std::uint32_t triangle) {
  const auto [a, b, c] = sphere_.in_order(mesh_.corners(triangle));
  Vertex& vertex = vertices_[triangle];
  vertex.direction = sphere_.centre(a, b, c);
  vertex.position = from_sphere(vertex.direction);
  vertex.is_exact = false;
}

void GeodesicVertices::place_on_earth(std::uint32_t triangle) {
  constexpr double farthest = 0.5;  // radians
  const auto [a, b, c] = sphere_.in_order(mesh_.corners(triangle));
  Vertex& vertex = vertices_[triangle];
  const auto found = equidistant_point(position(a), position(b), position(c), vertex.position);
  if (!found) return;
  const Direction direction = on_sphere(found->position);
  const Direction moved = direction - vertex.direction;
  if (dot(moved, moved) > farthest * farthest) return;
  vertex.position = found->position;
  vertex.direction = direction;
  vertex.radius = found->radius;
  vertex.is_exact = true;
}

void GeodesicVertices::find_near(const Box& frame) {
  for (std::uint32_t i = 0; i < mesh_.sides(); ++i) {
    const SideIndex s{i};
    if (mesh_.twin(s) < s) continue;
    const std::uint32_t start = CellMesh::triangle_of(mesh_.twin(s));
    const std::uint32_t end = CellMesh::triangle_of(s);
    if (vertices_[start].is_near && vertices_[end].is_near) continue;
    const GeodesicBisector between = edge(mesh_.from(s), mesh_.to(s));
    const auto [from, to] = angles(between, start, end);
    if (may_come_near(frame, between, from, to)) {
      vertices_[start].is_near = true;
      vertices_[end].is_near = true;
    }
  }
}

std::pair<double, double> GeodesicVertices::angles(const GeodesicBisector& edge,
                                                   std::uint32_t start, std::uint32_t end) const {
  return edge.arc().between(vertices_[group_of(start)].direction,
                            vertices_[group_of(end)].direction);
}

// Whether the point across from the side is nearer to the triangle's vertex than its corners are.
bool GeodesicVertices::holds_point_across(SideIndex s) const {
  const Vertex& vertex = vertices_[CellMesh::triangle_of(s)];
  const PlaceIndex corner = mesh_.apex(s);
  const PlaceIndex across = mesh_.apex(mesh_.twin(s));
  if (!vertex.is_exact || across == corner) return false;
  // Where it is much farther on the sphere, it is farther on the Earth.
  const double to_corner = sphere_.square_distance(vertex.direction, corner);
  const double to_across = sphere_.square_distance(vertex.direction, across);
  if (to_across > to_corner * scale_variation * scale_variation) return false;
  return geodesic_distance(position(across), vertex.position) < vertex.radius - within_circle;
}

void GeodesicVertices::flip_sides() {
  std::vector<SideIndex> open;
  for (std::uint32_t t = 0; t < mesh_.triangles(); ++t) {
    for (std::uint32_t i = 0; i < 3 && vertices_[t].is_near; ++i) {
      open.push_back(CellMesh::side(t, i));
    }
  }
  // Sides that go on flipping are at antipodes, where no choice is better than another.
  std::vector<std::uint8_t> flips(mesh_.triangles(), 0);
  constexpr std::uint8_t most_flips = 50;
  while (!open.empty()) {
    const SideIndex s = open.back();
    open.pop_back();
    const SideIndex beyond = mesh_.twin(s);
    if (!holds_point_across(s)) continue;
    const std::uint32_t t = CellMesh::triangle_of(s);
    const std::uint32_t w = CellMesh::triangle_of(beyond);
    if (flips[t] == most_flips || flips[w] == most_flips) continue;
    ++flips[t];
    ++flips[w];
    mesh_.flip(s);
    for (const std::uint32_t changed : {t, w}) {
      vertices_[changed].is_near = true;
      place_on_sphere(changed);
      place_on_earth(changed);
      for (std::uint32_t i = 0; i < 3; ++i) {
        open.push_back(CellMesh::side(changed, i));
        open.push_back(mesh_.twin(CellMesh::side(changed, i)));
      }
    }
  }
}

std::uint32_t GeodesicVertices::group_of(std::uint32_t triangle) const {
  return group_.empty() ? triangle : group_[triangle];
}

// Neighbouring vertices that cannot be told apart, as those of four gauges on a grid, are one.
void GeodesicVertices::unite() {
  DisjointSets groups(vertices_.size());
  for (std::uint32_t i = 0; i < mesh_.sides(); ++i) {
    const SideIndex s{i};
    const std::uint32_t a = groups.find(CellMesh::triangle_of(s));
    const std::uint32_t b = groups.find(CellMesh::triangle_of(mesh_.twin(s)));
    if (a == b) continue;
    const Direction apart = vertices_[CellMesh::triangle_of(s)].direction -
                            vertices_[CellMesh::triangle_of(mesh_.twin(s))].direction;
    if (dot(apart, apart) > indistinct * indistinct) continue;
    const bool keeps_a = sphere_.key_of(mesh_.corners(a)) < sphere_.key_of(mesh_.corners(b));
    groups.unite(keeps_a ? a : b, keeps_a ? b : a);
  }
  group_.resize(vertices_.size());
  for (std::uint32_t t = 0; t < group_.size(); ++t) group_[t] = groups.find(t);
}

}  // namespace thiessen
