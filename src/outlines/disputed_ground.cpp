#include "outlines/disputed_ground.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "outlines/ring_direction.h"
#include "outlines/ring_faces.h"
#include "outlines/winding_index.h"

namespace thiessen {
namespace {

/// What a ring is to its shape.
struct Role {
  std::size_t part;
  bool is_hole;
  int direction;  // 1 where the ring runs counter-clockwise on the whole, else -1
};

struct Rings {
  std::vector<Ring> rings;
  std::vector<Role> roles;

  void add(const Ring& ring, std::size_t part, bool is_hole) {
    rings.push_back(ring);
    roles.push_back({part, is_hole, signed_area(ring) < 0 ? -1 : 1});
  }
};

Rings rings_of(const MultiPolygon& shape) {
  Rings all;
  for (std::size_t part = 0; part < shape.size(); ++part) {
    all.add(shape[part].outer, part, false);
    for (const Ring& hole : shape[part].holes) all.add(hole, part, true);
  }
  return all;
}

int winding_number(const std::map<std::uint32_t, int>& windings, const std::vector<Role>& roles) {
  int sum = 0;
  for (const auto& [ring, times] : windings) {
    const Role& role = roles[ring];
    sum += times * role.direction * (role.is_hole ? -1 : 1);
  }
  return sum;
}

/// Whether a point lies in some part: in its shell and in none of its holes.
bool is_covered(const std::map<std::uint32_t, int>& windings, const std::vector<Role>& roles) {
  std::set<std::size_t> within;
  for (const auto& [ring, times] : windings) {
    if (!roles[ring].is_hole) within.insert(roles[ring].part);
  }
  for (const auto& [ring, times] : windings) {
    if (roles[ring].is_hole) within.erase(roles[ring].part);
  }
  return !within.empty();
}

template <typename Visit>
void for_each_corner(const Polygon& polygon, const Visit& visit) {
  std::for_each(polygon.outer.begin(), polygon.outer.end(), visit);
  for (const Ring& hole : polygon.holes) std::for_each(hole.begin(), hole.end(), visit);
}

/// The corner of a piece at which rings cross: one that is no vertex of a ring, else one that most
/// pieces share; of several the first by its coordinates.
Point crossing_at(const RingFace& piece, const std::vector<RingFace>& faces, const Rings& rings) {
  std::map<Point, std::size_t> shared;
  for_each_corner(piece.shape, [&](Point corner) { shared[corner] = 0; });
  for (const RingFace& face : faces) {
    for_each_corner(face.shape, [&](Point corner) {
      const auto found = shared.find(corner);
      if (found != shared.end()) ++found->second;
    });
  }
  std::set<Point> vertices;
  for (const Ring& ring : rings.rings) {
    for (const Point vertex : ring) {
      if (shared.contains(vertex)) vertices.insert(vertex);
    }
  }
  const auto rank = [&](const auto& corner) {
    return std::tuple(!vertices.contains(corner.first), corner.second);
  };
  return std::max_element(shared.begin(), shared.end(),
                          [&](const auto& a, const auto& b) { return rank(a) < rank(b); })
      ->first;
}

}  // namespace

Ground ground_of(const MultiPolygon& shape) {
  const Rings rings = rings_of(shape);
  const std::vector<RingFace> faces = faces_of(rings.rings, 0);
  const WindingIndex index(rings.rings);
  Ground ground;
  std::vector<const RingFace*> covered;
  const RingFace* largest = nullptr;
  for (const RingFace& face : faces) {
    const auto windings = index.at(face.within);
    if (is_covered(windings, rings.roles)) covered.push_back(&face);
    const int times = winding_number(windings, rings.roles);
    if (times == 0 || times == 1) continue;
    ground.disputed.push_back(face.shape);
    ground.disputed_area += face.area;
    if (largest == nullptr || face.area > largest->area) largest = &face;
  }
  for (const RingFace* face : covered) ground.area += face->area;
  ground.shape = united(covered);
  if (largest != nullptr) ground.place = crossing_at(*largest, faces, rings);
  return ground;
}

}  // namespace thiessen
