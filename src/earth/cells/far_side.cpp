#include "earth/cells/far_side.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "base/interrupt.h"
#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

// Edges are followed from so many radians before the antipode to so many beyond it.
constexpr double near_reach = 0.1;
constexpr double far_reach = 0.15;
constexpr double fine_angle = 1e-12;
// A place may be nearer to a vertex than those whose cells meet there by so many metres, because
// distances hardly differ there.
constexpr double slack = 1e-3;

}  // namespace

GeodesicBisector FarSide::bisector(const OpenSide& side) const {
  return {EarthPoint(position(side.from)), EarthPoint(position(side.to)),
          sphere_.bisector(side.from, side.to), accuracy_};
}

FarSide::Polygon FarSide::boundary_of(const std::vector<std::uint32_t>& triangles,
                                      const DirectionOf& direction_of) {
  const auto is_inside = [&](SideIndex s) {
    return std::binary_search(triangles.begin(), triangles.end(), CellMesh::triangle_of(s));
  };
  const auto is_open = [&](SideIndex s) { return !is_inside(mesh_.twin(s)); };
  std::optional<SideIndex> first;
  for (const std::uint32_t t : triangles) {
    for (std::uint32_t i = 0; i < 3 && !first; ++i) {
      if (is_open(CellMesh::side(t, i))) first = CellMesh::side(t, i);
    }
  }
  Polygon polygon;
  if (!first) return polygon;
  SideIndex s = *first;
  do {
    OpenSide side{mesh_.from(s), mesh_.to(s), mesh_.twin(s), 0, {}};
    side.angle = bisector(side).arc().angle_of(direction_of(CellMesh::triangle_of(side.outside)));
    polygon.push_back(side);
    // The next open side is found by going round the side's end, through the triangles inside.
    s = CellMesh::next(s);
    while (!is_open(s)) s = CellMesh::next(mesh_.twin(s));
  } while (s != *first && polygon.size() <= 3 * triangles.size());
  return polygon;
}

FarSide::Place FarSide::next(Place side) {
  return std::next(side) == polygon_.end() ? polygon_.begin() : std::next(side);
}

// Follows the edge between the cells of `from` and `to`, from where it enters, to the point to
// which the next side's `to` is as near.
void FarSide::find_meeting(Place side) {
  side->meeting.reset();
  const PlaceIndex third = next(side)->to;
  const GeodesicBisector edge = bisector(*side);
  const auto lead_over_third = [&](double angle) {
    const Point p = edge.find(angle).position;
    return geodesic_distance(position(third), p) - geodesic_distance(position(side->from), p);
  };
  double low = side->angle;
  double high = std::numbers::pi + far_reach;
  if (low < high - 2 * std::numbers::pi) low += 2 * std::numbers::pi;
  // At the point where the edge enters, the third place may already be as near.
  low = std::max(low, std::numbers::pi - near_reach);
  if (!(low < high) || !(lead_over_third(high) < 0)) return;
  if (lead_over_third(low) > 0) {
    while (high - low > fine_angle) {
      const double half = low + (high - low) / 2;
      (lead_over_third(half) > 0 ? low : high) = half;
    }
  }
  const Point p = edge.find(low).position;
  side->meeting = {p, geodesic_distance(position(side->from), p)};
}

bool FarSide::is_ear(Place side) const {
  if (!side->meeting) return false;
  const auto [p, radius] = *side->meeting;
  return std::all_of(polygon_.begin(), polygon_.end(),
                     [&, p = p, radius = radius](const OpenSide& other) {
                       return geodesic_distance(position(other.from), p) >= radius - slack;
                     });
}

std::optional<FarSide::Place> FarSide::find_ear() {
  for (Place side = polygon_.begin(); side != polygon_.end(); ++side) {
    if (is_ear(side)) return side;
  }
  return {};
}

std::vector<FarSide::Vertex> FarSide::lay_anew(const std::vector<std::uint32_t>& triangles,
                                               const DirectionOf& direction_of) {
  polygon_ = boundary_of(triangles, direction_of);
  if (polygon_.size() != triangles.size() + 2) return {};
  for (Place side = polygon_.begin(); side != polygon_.end(); ++side) find_meeting(side);
  std::vector<Ear> ears;
  for (const std::uint32_t t : triangles) {
    throw_if_interrupted();
    const auto ear = find_ear();
    if (!ear) return {};
    ears.push_back(cut(*ear, t));
  }
  std::vector<Vertex> vertices;
  for (const Ear& ear : ears) {
    mesh_.set_corners(ear.vertex.triangle, ear.corners);
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (ear.outside[i]) mesh_.join(CellMesh::side(ear.vertex.triangle, i), *ear.outside[i]);
    }
    vertices.push_back(ear.vertex);
  }
  return vertices;
}

// Cuts off the ear at a side. The last ear is the whole polygon that is left, so its third side has
// a triangle beyond it too.
FarSide::Ear FarSide::cut(Place first, std::uint32_t triangle) {
  const Place second = next(first);
  Ear ear{{triangle, *first->meeting},
          {first->from, first->to, second->to},
          {second->outside, {}, first->outside}};
  if (polygon_.size() == 3) {
    ear.outside[1] = next(second)->outside;
    polygon_.clear();
    return ear;
  }
  first->to = second->to;
  first->outside = CellMesh::side(triangle, 1);
  polygon_.erase(second);
  first->angle = bisector(*first).arc().angle_of(on_sphere(ear.vertex.at.position));
  find_meeting(first);
  find_meeting(first == polygon_.begin() ? std::prev(polygon_.end()) : std::prev(first));
  return ear;
}

}  // namespace thiessen
