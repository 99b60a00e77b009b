#include "earth/cells/geodesic_vertices.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "earth/cells/edge_drawing.h"
#include "earth/cells/equidistance.h"
#include "earth/cells/far_side.h"
#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/geodesic.h"
#include "earth/sphere/nearby_positions.h"
#include "earth/sphere/units.h"
#include "geometry/disjoint_sets.h"

namespace thiessen {
namespace {

/// Which directions are within a frame less than half a turn wide. It may say no of some, where the
/// frame reaches a pole or is wider.
class FrameOnSphere {
 public:
  explicit FrameOnSphere(const Box& frame)
      : is_told_(frame.width() < 170 && frame.low.y > -89 && frame.high.y < 89),
        south_(on_sphere(frame.low).z),
        north_(on_sphere(frame.high).z),
        west_(on_sphere({frame.low.x, 0})),
        east_(on_sphere({frame.high.x, 0})) {}

  bool holds(Direction p) const {
    return is_told_ && p.z > south_ && p.z < north_ && west_.x * p.y - west_.y * p.x > 0 &&
           east_.x * p.y - east_.y * p.x < 0;
  }

 private:
  bool is_told_;
  double south_;
  double north_;
  Direction west_;
  Direction east_;
};

/// The point with its longitude in [-180, 180].
Point within_turn(Point p) {
  return std::abs(p.x) <= 180 ? p : Point{std::remainder(p.x, 360), p.y};
}

}  // namespace

GeodesicVertices::GeodesicVertices(const SphereTessellation& sphere, std::span<const Point> places,
                                   const Box& frame, double accuracy, unsigned threads)
    : sphere_(sphere),
      places_(places),
      accuracy_(accuracy),
      mesh_(sphere),
      vertices_(mesh_.triangles()) {
  scales_.reserve(places.size());
  for (std::uint32_t p = 0; p < places.size(); ++p)
    scales_.push_back(sphere_scale().at(sphere.direction(PlaceIndex{p}).z));
  const FrameOnSphere frame_on_sphere(frame);
  for (std::uint32_t t = 0; t < mesh_.triangles(); ++t) {
    place_on_sphere(t);
    vertices_[t].is_near = frame_on_sphere.holds(vertices_[t].direction) || is_near_frame(frame, t);
  }
  lay_far_side_anew();
  constexpr std::size_t some = 256;
  in_parallel((vertices_.size() + some - 1) / some, threads, [&](std::size_t, std::size_t piece) {
    const std::size_t end = std::min(vertices_.size(), (piece + 1) * some);
    for (std::size_t t = piece * some; t < end; ++t) {
      if (vertices_[t].is_near && !vertices_[t].is_far)
        place_on_earth(static_cast<std::uint32_t>(t));
    }
  });
  flip_sides();
  unite();
}

bool GeodesicVertices::is_near_frame(const Box& frame, std::uint32_t triangle) {
  Vertex& vertex = vertices_[triangle];
  vertex.position = position_near_corner(triangle);
  return may_come_near(frame, vertex.position, farthest_off(triangle));
}

Point GeodesicVertices::position_near_corner(std::uint32_t triangle) const {
  const PlaceIndex corner = corners_in_order(triangle)[0];
  const NearbyPositions near(position(corner), sphere_.direction(corner));
  return within_turn(near.of(vertices_[triangle].direction));
}

// An upper bound, in degrees, on how far the vertex moves from the sphere to the ellipsoid.
double GeodesicVertices::farthest_off(std::uint32_t triangle) const {
  const double square =
      sphere_.square_distance(vertices_[triangle].direction, mesh_.corners(triangle)[0]);
  return std::min(1.0, 0.1 * std::sqrt(square) / degree + 1e-6);
}

void GeodesicVertices::place_on_sphere(std::uint32_t triangle) {
  Vertex& vertex = vertices_[triangle];
  vertex.first = sphere_.first_corner(mesh_.corners(triangle));
  const auto [a, b, c] = corners_in_order(triangle);
  vertex.direction = sphere_.centre(a, b, c);
  vertex.is_exact = false;
}

// Lays anew the triangles whose circles cover nearly half the Earth, if one of their vertices is
// near the frame.
void GeodesicVertices::lay_far_side_anew() {
  const double cosine = -std::cos(0.06);  // 380 km from the antipode
  std::vector<std::uint32_t> far;
  bool any_near = false;
  for (std::uint32_t t = 0; t < vertices_.size(); ++t) {
    const Direction corner = sphere_.direction(mesh_.corners(t)[0]);
    if (dot(vertices_[t].direction, corner) > cosine) continue;
    far.push_back(t);
    any_near = any_near || vertices_[t].is_near;
  }
  if (!any_near) return;
  const auto direction_of = [&](std::uint32_t t) { return vertices_[t].direction; };
  for (const std::uint32_t t : far) {
    vertices_[t].is_far = true;
    vertices_[t].position = from_sphere(vertices_[t].direction);
  }
  for (const auto& [t, at] :
       FarSide(sphere_, places_, accuracy_, mesh_).lay_anew(far, direction_of))
    vertices_[t] = {at.position, on_sphere(at.position), at.radius, true, true, true};
}

void GeodesicVertices::place_on_earth(std::uint32_t triangle) {
  constexpr double farthest = 0.5;  // radians
  const auto [a, b, c] = corners_in_order(triangle);
  Vertex& vertex = vertices_[triangle];
  const auto found = equidistant_point({earth_point(a), earth_point(b), earth_point(c)},
                                       {scales_[index(a)], scales_[index(b)], scales_[index(c)]},
                                       vertex.direction, accuracy_ / 10);
  const auto is_close = [&](Direction at) {
    const Direction moved = at - vertex.direction;
    return dot(moved, moved) <= farthest * farthest;
  };
  if (found && is_close(found->at)) {
    vertex.direction = found->at;
    vertex.radius = found->radius;
    vertex.is_exact = true;
  }
  vertex.position = position_near_corner(triangle);
}

std::optional<GeodesicVertices::Border> GeodesicVertices::border(SideIndex s) const {
  Border border{mesh_.from(s), mesh_.to(s), group_of(CellMesh::triangle_of(mesh_.twin(s))),
                group_of(CellMesh::triangle_of(s))};
  if (border.start == border.end) return std::nullopt;
  if (position(border.right) < position(border.left)) {
    std::swap(border.left, border.right);
    std::swap(border.start, border.end);
  }
  return border;
}

std::pair<double, double> GeodesicVertices::angles(const GeodesicBisector& edge,
                                                   std::uint32_t start, std::uint32_t end) const {
  return edge.arc().between(vertices_[group_of(start)].direction,
                            vertices_[group_of(end)].direction);
}

// Whether the sphere does not tell that holds_point_across says no: a place that is much farther on
// the sphere is farther on the Earth too.
bool GeodesicVertices::may_hold_point_across(SideIndex s) const {
  const Vertex& vertex = vertices_[CellMesh::triangle_of(s)];
  const PlaceIndex corner = mesh_.apex(s);
  const PlaceIndex across = mesh_.apex(mesh_.twin(s));
  if (!vertex.is_exact || across == corner) return false;
  const double to_corner = sphere_.square_distance(vertex.direction, corner);
  const double to_across = sphere_.square_distance(vertex.direction, across);
  return to_across <= to_corner * scale_variation * scale_variation;
}

// Whether the point across from the side is nearer to the triangle's vertex than its corners are,
// by more than `margin` metres.
bool GeodesicVertices::holds_point_across(SideIndex s, double margin) const {
  if (!may_hold_point_across(s)) return false;
  const Vertex& vertex = vertices_[CellMesh::triangle_of(s)];
  const PlaceIndex across = mesh_.apex(mesh_.twin(s));
  return geodesic_distance(position(across), vertex.position) < vertex.radius - margin;
}

// The circles of both triangles agree, except at antipodes, where they hardly tell one place from
// another. There a circle that says no is believed.
bool GeodesicVertices::is_to_be_flipped(SideIndex s) const {
  // The margin is more than the noise of distances.
  const double within_circle = accuracy_ / 5;
  const SideIndex beyond = mesh_.twin(s);
  if (vertices_[CellMesh::triangle_of(s)].is_far || vertices_[CellMesh::triangle_of(beyond)].is_far)
    return false;
  return holds_point_across(s, within_circle) &&
         (!vertices_[CellMesh::triangle_of(beyond)].is_exact ||
          holds_point_across(beyond, -within_circle));
}

void GeodesicVertices::flip_sides() {
  std::vector<SideIndex> open;
  for (std::uint32_t t = 0; t < mesh_.triangles(); ++t) {
    for (std::uint32_t i = 0; i < 3 && vertices_[t].is_near; ++i) {
      const SideIndex s = CellMesh::side(t, i);
      if (may_hold_point_across(s)) open.push_back(s);
    }
  }
  // Sides that keep flipping are at antipodes, where no choice is better than another, so flips are
  // counted and stopped.
  std::vector<std::uint8_t> flips(mesh_.triangles(), 0);
  constexpr std::uint8_t most_flips = 50;
  while (!open.empty()) {
    const SideIndex s = open.back();
    open.pop_back();
    const SideIndex beyond = mesh_.twin(s);
    if (!is_to_be_flipped(s)) continue;
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

bool GeodesicVertices::may_be_flipped(SideIndex s) const {
  const Vertex& vertex = vertices_[CellMesh::triangle_of(s)];
  if (vertex.is_exact && vertices_[CellMesh::triangle_of(mesh_.twin(s))].is_exact) return false;
  const double to_corner = sphere_.square_distance(vertex.direction, mesh_.apex(s));
  const double to_across = sphere_.square_distance(vertex.direction, mesh_.apex(mesh_.twin(s)));
  return to_across <= to_corner * scale_variation * scale_variation;
}

std::uint32_t GeodesicVertices::group_of(std::uint32_t triangle) const {
  return group_.empty() ? triangle : group_[triangle];
}

// Unites neighbouring vertices that cannot be told apart, such as those of four gauges on a grid.
void GeodesicVertices::unite() {
  const double indistinct = 2 * accuracy_ / mean_radius;
  DisjointSets groups(vertices_.size());
  for (std::uint32_t i = 0; i < mesh_.sides(); ++i) {
    const SideIndex s{i};
    if (mesh_.twin(s) < s) continue;
    const Direction apart = vertices_[CellMesh::triangle_of(s)].direction -
                            vertices_[CellMesh::triangle_of(mesh_.twin(s))].direction;
    if (dot(apart, apart) > indistinct * indistinct) continue;
    const std::uint32_t a = groups.find(CellMesh::triangle_of(s));
    const std::uint32_t b = groups.find(CellMesh::triangle_of(mesh_.twin(s)));
    if (a == b) continue;
    const bool keeps_a = sphere_.key_of(mesh_.corners(a)) < sphere_.key_of(mesh_.corners(b));
    groups.unite(keeps_a ? a : b, keeps_a ? b : a);
  }
  group_.resize(vertices_.size());
  for (std::uint32_t t = 0; t < group_.size(); ++t) group_[t] = groups.find(t);
}

}  // namespace thiessen
