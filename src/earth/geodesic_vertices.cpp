#include "earth/geodesic_vertices.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/parallel.h"
#include "earth/edge_drawing.h"
#include "earth/equidistance.h"
#include "earth/geodesic.h"

namespace thiessen {
namespace {

constexpr double pi = std::numbers::pi;
// How much nearer, in metres, a point must be to a vertex to be within its circle: more than the
// noise of distances.
constexpr double within_circle = 2e-7;
// Radians: 2 micrometres.
constexpr double indistinct = 3e-13;

// The difference of directions has their rounding, which turns a chord of length s by 1e-16 / s: it
// is taken only where that is below `turned_at_most`.
Direction chord_between(const SphereTessellation& sphere, Point a_position, Point b_position,
                        PlaceIndex a, PlaceIndex b, double turned_at_most) {
  const Direction difference = sphere.direction(b) - sphere.direction(a);
  const double shortest = 1e-16 / turned_at_most;
  return dot(difference, difference) > shortest * shortest
             ? difference
             : chord_on_sphere(a_position, b_position);
}

}  // namespace

BisectorArc bisector_on_sphere(const SphereTessellation& sphere, Point first_position,
                               Point second_position, PlaceIndex first, PlaceIndex second) {
  return {sphere.direction(first), sphere.direction(second),
          chord_between(sphere, first_position, second_position, first, second, 1e-12)};
}

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

Direction GeodesicVertices::chord(PlaceIndex a, PlaceIndex b) const {
  return chord_between(sphere_, position(a), position(b), a, b, 1e-15);
}

// Beginning with the first by coordinates, so that rounding is the same for any order of places.
std::array<PlaceIndex, 3> GeodesicVertices::ordered_corners(std::uint32_t triangle) const {
  auto corners = mesh_.corners(triangle);
  std::rotate(
      corners.begin(),
      std::min_element(corners.begin(), corners.end(),
                       [&](PlaceIndex a, PlaceIndex b) { return position(a) < position(b); }),
      corners.end());
  return corners;
}

void GeodesicVertices::place_on_sphere(std::uint32_t triangle) {
  const auto [a, b, c] = ordered_corners(triangle);
  Vertex& vertex = vertices_[triangle];
  vertex.direction = unit(cross(chord(a, b), chord(a, c)));
  vertex.position = from_sphere(vertex.direction);
  vertex.is_exact = false;
}

void GeodesicVertices::place_on_earth(std::uint32_t triangle) {
  constexpr double farthest = 3e6;
  const auto [a, b, c] = ordered_corners(triangle);
  Vertex& vertex = vertices_[triangle];
  const auto found = equidistant_point(position(a), position(b), position(c), vertex.position);
  if (!found || geodesic_distance(*found, vertex.position) > farthest) return;
  vertex.position = *found;
  vertex.direction = on_sphere(*found);
  vertex.radius = geodesic_distance(position(a), *found);
  vertex.is_exact = true;
}

void GeodesicVertices::find_near(const Box& frame) {
  for (std::uint32_t i = 0; i < mesh_.sides(); ++i) {
    const SideIndex s{i};
    if (mesh_.twin(s) < s) continue;
    const std::uint32_t start = CellMesh::triangle_of(mesh_.twin(s));
    const std::uint32_t end = CellMesh::triangle_of(s);
    if (vertices_[start].is_near && vertices_[end].is_near) continue;
    const BisectorArc arc = bisector_on_sphere(sphere_, position(mesh_.from(s)),
                                               position(mesh_.to(s)), mesh_.from(s), mesh_.to(s));
    const auto [from, to] = angles(arc, start, end);
    if (may_come_near(frame, arc, from, to)) {
      vertices_[start].is_near = true;
      vertices_[end].is_near = true;
    }
  }
}

std::pair<double, double> GeodesicVertices::angles(const BisectorArc& arc, std::uint32_t start,
                                                   std::uint32_t end) const {
  const double from = arc.angle_of(vertices_[group_of(start)].direction);
  // No edge is longer than half a circle, so a turn far backward is one forward; a little backward
  // is rounding.
  double turn = std::remainder(arc.angle_of(vertices_[group_of(end)].direction) - from, 2 * pi);
  if (turn < -pi / 2) turn += 2 * pi;
  return {from, from + std::max(turn, 0.0)};
}

// Whether the point across from the side is nearer to the triangle's vertex than its corners are.
bool GeodesicVertices::holds_point_across(SideIndex s) const {
  const Vertex& vertex = vertices_[CellMesh::triangle_of(s)];
  const PlaceIndex across = mesh_.apex(mesh_.twin(s));
  return vertex.is_exact && across != mesh_.apex(s) &&
         geodesic_distance(position(across), vertex.position) < vertex.radius - within_circle;
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
  std::vector<std::uint32_t> group(vertices_.size());
  std::iota(group.begin(), group.end(), 0u);
  const auto find = [&](std::uint32_t t) {
    while (group[t] != t) t = group[t] = group[group[t]];
    return t;
  };
  for (std::uint32_t i = 0; i < mesh_.sides(); ++i) {
    const SideIndex s{i};
    const std::uint32_t a = find(CellMesh::triangle_of(s));
    const std::uint32_t b = find(CellMesh::triangle_of(mesh_.twin(s)));
    if (a == b) continue;
    const Direction apart = vertices_[CellMesh::triangle_of(s)].direction -
                            vertices_[CellMesh::triangle_of(mesh_.twin(s))].direction;
    if (dot(apart, apart) > indistinct * indistinct) continue;
    const bool keeps_a = key_of(a) < key_of(b);
    group[keeps_a ? b : a] = keeps_a ? a : b;
  }
  for (std::uint32_t t = 0; t < group.size(); ++t) group[t] = find(t);
  group_ = std::move(group);
}

std::array<Point, 3> GeodesicVertices::key_of(std::uint32_t triangle) const {
  const auto corners = mesh_.corners(triangle);
  std::array<Point, 3> key{position(corners[0]), position(corners[1]), position(corners[2])};
  std::sort(key.begin(), key.end());
  return key;
}

}  // namespace thiessen
