#include "tessellation/audit.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "geometry/predicates.h"

namespace thiessen {
namespace {

/// A layer's view of the structure, and what it finds there.
class Inspection {
 public:
  Inspection(const Topology<2>& topology, std::span<const Point> positions)
      : topology_(topology), positions_(positions) {}

  const Topology<2>& topology() const { return topology_; }
  Point position(PointId p) const { return positions_[index(p)]; }
  void find(Fault fault, VertexId v) { findings_.push_back({fault, v, place_of(v)}); }
  std::vector<Finding> findings() && { return std::move(findings_); }

  template <typename Visit>
  void for_each_vertex(Visit&& visit) const {
    for (std::uint32_t i = 0; i < topology_.size(); ++i) {
      if (!topology_.is_free(VertexId{i})) visit(VertexId{i});
    }
  }

 private:
  Point place_of(VertexId v) const {
    for (const PointId p : topology_.forming(v)) {
      if (p != infinite_point && index(p) < positions_.size()) return position(p);
    }
    return {};
  }

  const Topology<2>& topology_;
  std::span<const Point> positions_;
  std::vector<Finding> findings_;
};

bool has_repeated_point(const Topology<2>::Forming& forming) {
  return forming[0] == forming[1] || forming[1] == forming[2] || forming[2] == forming[0];
}

void inspect_link(Inspection& inspection, VertexId v, std::size_t side) {
  const Topology<2>& topology = inspection.topology();
  const VertexId w = topology.neighbour(v, side);
  if (index(w) >= topology.size() || topology.is_free(w)) {
    inspection.find(Fault::link_to_nothing, v);
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (topology.neighbour(w, i) != v) continue;
    const auto& ours = topology.forming(v);
    const auto& theirs = topology.forming(w);
    // Both run counter-clockwise, so the edge runs the other way there.
    if (ours[(side + 1) % 3] == theirs[(i + 2) % 3] && ours[(side + 2) % 3] == theirs[(i + 1) % 3])
      return;
  }
  const bool returned = topology.neighbour(w, 0) == v || topology.neighbour(w, 1) == v ||
                        topology.neighbour(w, 2) == v;
  inspection.find(returned ? Fault::edge_not_shared : Fault::link_not_returned, v);
}

/// How many vertices are reached from the first by links.
std::size_t count_reached(const Topology<2>& topology, VertexId first) {
  std::vector<bool> reached(topology.size(), false);
  std::vector<VertexId> open{first};
  reached[index(first)] = true;
  std::size_t count = 0;
  while (!open.empty()) {
    const VertexId v = open.back();
    open.pop_back();
    ++count;
    for (std::size_t side = 0; side < 3; ++side) {
      const VertexId w = topology.neighbour(v, side);
      if (reached[index(w)]) continue;
      reached[index(w)] = true;
      open.push_back(w);
    }
  }
  return count;
}

void inspect_surface(Inspection& inspection, std::size_t positions) {
  const Topology<2>& topology = inspection.topology();
  std::vector<bool> has_simplex(positions, false);
  std::size_t simplices = 0;
  VertexId first = no_vertex;
  inspection.for_each_vertex([&](VertexId v) {
    if (simplices++ == 0) first = v;
    for (const PointId p : topology.forming(v)) {
      if (p != infinite_point) has_simplex[index(p)] = true;
    }
  });
  if (simplices == 0) return;
  const auto points =
      static_cast<std::size_t>(std::count(has_simplex.begin(), has_simplex.end(), true)) + 1;
  if (simplices + 4 != 2 * points || count_reached(topology, first) != simplices)
    inspection.find(Fault::surface_not_a_sphere, first);
}

// The hull runs from→to round the outside; `outside` has the infinite point.
void inspect_hull_corner(Inspection& inspection, VertexId outside, std::size_t& first_corners) {
  const Topology<2>& topology = inspection.topology();
  const std::size_t infinite = topology.corner_of(outside, infinite_point);
  const auto& forming = topology.forming(outside);
  const VertexId following = topology.neighbour(outside, (infinite + 1) % 3);
  const std::size_t there = topology.corner_of(following, infinite_point);
  const Point before = inspection.position(forming[(infinite + 1) % 3]);
  const Point corner = inspection.position(forming[(infinite + 2) % 3]);
  const Point after = inspection.position(topology.forming(following)[(there + 2) % 3]);
  // Seen from outside, the points go clockwise round the hull.
  if (orientation(before, corner, after) > 0) inspection.find(Fault::hull_not_convex, outside);
  if (corner < before && corner < after) ++first_corners;
}

std::vector<Finding> audit_line(const Tessellation& tessellation) {
  std::vector<Finding> findings;
  const std::vector<PointId> line = tessellation.along_line();
  const auto at = [&](std::size_t i) { return tessellation.position(line[i]); };
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (!(at(i - 1) < at(i))) findings.push_back({Fault::points_out_of_order, no_vertex, at(i)});
    if (orientation(at(0), at(line.size() - 1), at(i)) != 0)
      findings.push_back({Fault::point_off_line, no_vertex, at(i)});
  }
  return findings;
}

std::vector<Finding> audit_simplices_of_points(const Tessellation& tessellation) {
  std::vector<Finding> findings;
  const Topology<2>& topology = tessellation.topology();
  for (std::uint32_t i = 0; i < tessellation.size(); ++i) {
    const PointId p{i};
    const VertexId v = tessellation.vertex_of(p);
    if (v == no_vertex) continue;
    const bool stands = index(v) < topology.size() && !topology.is_free(v);
    if (!stands || topology.corner_of(v, p) == Topology<2>::corners)
      findings.push_back({Fault::point_without_simplex, v, tessellation.position(p)});
  }
  return findings;
}

}  // namespace

std::string_view name_of(Fault fault) {
  static constexpr std::array<std::string_view, 13> names{"repeated forming point",
                                                          "link to nothing",
                                                          "link not returned",
                                                          "edge not shared",
                                                          "point without simplex",
                                                          "surface not a sphere",
                                                          "simplex not left-turning",
                                                          "hull not convex",
                                                          "hull winds again",
                                                          "point in circle",
                                                          "tie broken otherwise",
                                                          "points out of order",
                                                          "point off line"};
  return names.at(static_cast<std::size_t>(fault));
}

std::vector<Finding> audit_links(const Topology<2>& topology, std::span<const Point> positions) {
  Inspection inspection(topology, positions);
  bool sound = true;
  inspection.for_each_vertex([&](VertexId v) {
    if (has_repeated_point(topology.forming(v))) {
      inspection.find(Fault::repeated_forming_point, v);
    }
    for (std::size_t side = 0; side < 3; ++side) {
      const VertexId w = topology.neighbour(v, side);
      sound = sound && index(w) < topology.size() && !topology.is_free(w);
      inspect_link(inspection, v, side);
    }
  });
  if (sound) inspect_surface(inspection, positions.size());
  return std::move(inspection).findings();
}

std::vector<Finding> audit_plane(const Topology<2>& topology, std::span<const Point> positions) {
  Inspection inspection(topology, positions);
  std::size_t first_corners = 0;
  VertexId outside = no_vertex;
  inspection.for_each_vertex([&](VertexId v) {
    if (topology.is_infinite(v)) {
      outside = v;
      inspect_hull_corner(inspection, v, first_corners);
      return;
    }
    const auto& forming = topology.forming(v);
    const auto at = [&](std::size_t i) { return inspection.position(forming[i]); };
    if (orientation(at(0), at(1), at(2)) <= 0) inspection.find(Fault::simplex_not_left_turning, v);
  });
  if (first_corners != 1) inspection.find(Fault::hull_winds_again, outside);
  return std::move(inspection).findings();
}

std::vector<Finding> audit_circles(const Topology<2>& topology, std::span<const Point> positions) {
  Inspection inspection(topology, positions);
  inspection.for_each_vertex([&](VertexId v) {
    if (topology.is_infinite(v)) return;
    const auto& forming = topology.forming(v);
    const auto at = [&](std::size_t i) { return inspection.position(forming[i]); };
    for (std::size_t side = 0; side < 3; ++side) {
      const VertexId w = topology.neighbour(v, side);
      if (topology.is_infinite(w)) continue;
      const Point across = inspection.position(topology.forming(w)[topology.side_towards(w, v)]);
      if (!in_perturbed_circle(at(0), at(1), at(2), across)) continue;
      const bool tie = in_circle(at(0), at(1), at(2), across) == 0;
      inspection.find(tie ? Fault::tie_broken_otherwise : Fault::point_in_circle, v);
    }
  });
  return std::move(inspection).findings();
}

std::vector<Finding> audit(const Tessellation& tessellation) {
  if (tessellation.span() != Span::plane) return audit_line(tessellation);
  const Topology<2>& topology = tessellation.topology();
  const std::span<const Point> positions = tessellation.positions();
  std::vector<Finding> findings = audit_links(topology, positions);
  if (findings.empty()) findings = audit_simplices_of_points(tessellation);
  if (findings.empty()) findings = audit_plane(topology, positions);
  if (findings.empty()) findings = audit_circles(topology, positions);
  return findings;
}

}  // namespace thiessen
