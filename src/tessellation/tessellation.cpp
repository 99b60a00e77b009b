#include "tessellation/tessellation.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/hilbert.h"
#include "geometry/predicates.h"

namespace thiessen {

Span Tessellation::span() const {
  if (plane_) return Span::plane;
  if (line_.size() > 1) return Span::line;
  return line_.empty() ? Span::nothing : Span::point;
}

std::vector<PointId> Tessellation::along_line() const {
  return line_;
}

PointId Tessellation::add(Point point) {
  const PointId q{static_cast<std::uint32_t>(positions_.size())};
  positions_.push_back(point);
  vertex_of_.push_back(no_vertex);
  const PointId found = insert(q);
  if (found != q) {
    positions_.pop_back();
    vertex_of_.pop_back();
  }
  return found;
}

std::vector<PointId> Tessellation::add_all(std::span<const Point> points) {
  const auto first = static_cast<std::uint32_t>(positions_.size());
  positions_.insert(positions_.end(), points.begin(), points.end());
  vertex_of_.resize(positions_.size(), no_vertex);

  std::vector<PointId> inserted(points.size());
  std::vector<std::uint32_t> order = insertion_order(points);
  if (!plane_) {
    // Points on one line are merged at once; one that is off it goes first.
    std::vector<PointId> on_line = line_;
    for (const std::uint32_t i : order) on_line.push_back(PointId{first + i});
    insert_all_in_line(on_line);
    for (std::size_t i = 0; i < line_.size(); ++i) {
      if (index(line_[i]) >= first) inserted[index(line_[i]) - first] = line_[i];
    }
  }
  for (const std::uint32_t i : order) inserted[i] = insert(PointId{first + i});
  return inserted;
}

PointId Tessellation::insert(PointId q) {
  if (plane_) return insert_in_plane(q);
  return insert_in_line(q);
}

// A first stretch of points, as far as they lie on one line: all of them where none is off it.
void Tessellation::insert_all_in_line(std::span<const PointId> points) {
  const auto at = [&](PointId p) { return positions_[index(p)]; };
  const auto different = std::find_if(points.begin(), points.end(),
                                      [&](PointId p) { return at(p) != at(points.front()); });
  if (different == points.end()) return;
  const auto off_line = std::find_if(points.begin(), points.end(), [&](PointId p) {
    return orientation(at(points.front()), at(*different), at(p)) != 0;
  });
  std::vector<PointId> line(points.begin(), off_line);
  std::stable_sort(line.begin(), line.end(), [&](PointId a, PointId b) { return at(a) < at(b); });
  line.erase(
      std::unique(line.begin(), line.end(), [&](PointId a, PointId b) { return at(a) == at(b); }),
      line.end());
  line_ = std::move(line);
}

PointId Tessellation::insert_in_line(PointId q) {
  const Point position = positions_[index(q)];
  if (line_.size() > 1 && orientation(positions_[index(line_.front())],
                                      positions_[index(line_.back())], position) != 0) {
    raise_to_plane(q);
    return q;
  }
  const auto place =
      std::lower_bound(line_.begin(), line_.end(), position,
                       [&](PointId p, Point sought) { return positions_[index(p)] < sought; });
  if (place != line_.end() && positions_[index(*place)] == position) return *place;
  line_.insert(place, q);
  return q;
}

void Tessellation::raise_to_plane(PointId apex) {
  std::vector<PointId> line = std::exchange(line_, {});
  const auto at = [&](PointId p) { return positions_[index(p)]; };
  if (orientation(at(line.front()), at(line.back()), at(apex)) < 0)
    std::reverse(line.begin(), line.end());

  std::vector<Topology<2>::Forming> simplices;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    simplices.push_back({apex, line[i], line[i + 1]});
    simplices.push_back({infinite_point, line[i + 1], line[i]});
  }
  simplices.push_back({infinite_point, apex, line.back()});
  simplices.push_back({infinite_point, line.front(), apex});

  std::map<std::pair<PointId, PointId>, std::pair<VertexId, std::size_t>> side_of_edge;
  for (const auto& forming : simplices) {
    const VertexId v = topology_.allocate(forming);
    for (std::size_t i = 0; i < 3; ++i) {
      const PointId from = forming[(i + 1) % 3];
      const PointId to = forming[(i + 2) % 3];
      if (forming[i] != infinite_point) vertex_of_[index(forming[i])] = v;
      side_of_edge[{from, to}] = {v, i};
      const auto twin = side_of_edge.find({to, from});
      if (twin != side_of_edge.end()) topology_.link(v, i, twin->second.first, twin->second.second);
    }
    last_ = v;
  }
  plane_ = true;
}

// Steps 1 to 6 of section 2.2.
PointId Tessellation::insert_in_plane(PointId q) {
  const Point position = positions_[index(q)];
  const VertexId first = locate(position, last_);
  for (const PointId p : topology_.forming(first)) {
    if (p != infinite_point && positions_[index(p)] == position) return p;
  }
  find_deleted_vertices(first, position);
  find_outer_edges();
  for (const VertexId v : deleted_) topology_.release(v);
  allocate_new_vertices(q);
  return q;
}

bool Tessellation::in_conflict(VertexId v, Point q) const {
  const auto& forming = topology_.forming(v);
  const std::size_t infinite = topology_.corner_of(v, infinite_point);
  const auto at = [&](std::size_t i) { return positions_[index(forming[i % 3])]; };
  if (infinite == 3) return in_perturbed_circle(at(0), at(1), at(2), q);
  const Point a = at(infinite + 1);
  const Point b = at(infinite + 2);
  const int side = orientation(a, b, q);
  if (side != 0) return side > 0;
  return std::min(a, b) < q && q < std::max(a, b);
}

// Step 1: the vertices nearer to q than to their forming points. They are connected.
void Tessellation::find_deleted_vertices(VertexId first, Point q) {
  is_deleted_.resize(topology_.size(), 0);
  deleted_.assign(1, first);
  is_deleted_[index(first)] = 1;
  for (std::size_t next = 0; next < deleted_.size(); ++next) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId w = topology_.neighbour(deleted_[next], i);
      if (is_deleted_[index(w)] != 0 || !in_conflict(w, q)) continue;
      is_deleted_[index(w)] = 1;
      deleted_.push_back(w);
    }
  }
}

// Steps 2 and 3: each edge between a deleted vertex and a kept one will be q's opposite in a new
// simplex.
void Tessellation::find_outer_edges() {
  outer_edges_.clear();
  for (const VertexId v : deleted_) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId w = topology_.neighbour(v, i);
      if (is_deleted_[index(w)] != 0) continue;
      const auto& forming = topology_.forming(v);
      outer_edges_.push_back(
          {forming[(i + 1) % 3], forming[(i + 2) % 3], w, topology_.side_towards(w, v)});
    }
  }
  for (const VertexId v : deleted_) is_deleted_[index(v)] = 0;
}

// Steps 4 to 6: the new vertices, their outer neighbours, and those among themselves, a ring round
// q.
void Tessellation::allocate_new_vertices(PointId q) {
  VertexId starting_at_infinity = no_vertex;
  const auto starting_at = [&](PointId p) -> VertexId& {
    return p == infinite_point ? starting_at_infinity : vertex_of_[index(p)];
  };
  for (const OuterEdge& edge : outer_edges_) {
    const VertexId v = topology_.allocate({q, edge.from, edge.to});
    topology_.link(v, 0, edge.beyond, edge.side);
    starting_at(edge.from) = v;
    last_ = v;
  }
  for (const OuterEdge& edge : outer_edges_) {
    topology_.link(starting_at(edge.from), 1, starting_at(edge.to), 2);
  }
  vertex_of_[index(q)] = last_;
}

VertexId Tessellation::locate(Point q, VertexId hint) const {
  VertexId v = hint;
  const std::size_t infinite = topology_.corner_of(v, infinite_point);
  if (infinite != 3) v = topology_.neighbour(v, infinite);
  VertexId before = no_vertex;
  for (;;) {
    const auto& forming = topology_.forming(v);
    VertexId next = no_vertex;
    for (std::size_t i = 0; i < 3 && next == no_vertex; ++i) {
      const VertexId w = topology_.neighbour(v, i);
      if (w == before) continue;
      const Point a = positions_[index(forming[(i + 1) % 3])];
      const Point b = positions_[index(forming[(i + 2) % 3])];
      if (orientation(a, b, q) < 0) next = w;
    }
    if (next == no_vertex) return v;
    if (topology_.is_infinite(next)) return next;
    before = v;
    v = next;
  }
}

std::optional<PointId> Tessellation::nearest(Point to, std::optional<PointId> hint) const {
  std::vector<PointId> nearest;
  find_nearest(to, hint, nearest);
  if (nearest.empty()) return {};
  return *std::min_element(nearest.begin(), nearest.end(), [&](PointId a, PointId b) {
    return positions_[index(a)] < positions_[index(b)];
  });
}

void Tessellation::find_nearest(Point to, std::optional<PointId> hint,
                                std::vector<PointId>& nearest) const {
  nearest.clear();
  if (plane_) {
    find_nearest_in_plane(to, hint, nearest);
  } else if (!line_.empty()) {
    find_nearest_on_line(to, nearest);
  }
}

// Along the line the distance falls, then rises: two neighbours may be as near.
void Tessellation::find_nearest_on_line(Point to, std::vector<PointId>& nearest) const {
  const auto at = [&](std::size_t i) { return positions_[index(line_[i])]; };
  std::size_t low = 0;
  std::size_t high = line_.size() - 1;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (compare_distance(to, at(middle + 1), at(middle)) < 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  nearest.push_back(line_[low]);
  if (low + 1 < line_.size() && compare_distance(to, at(low), at(low + 1)) == 0) {
    nearest.push_back(line_[low + 1]);
  }
}

// From neighbour to nearer neighbour. Equally near points lie on one circle, along which Delaunay
// edges connect them.
void Tessellation::find_nearest_in_plane(Point to, std::optional<PointId> hint,
                                         std::vector<PointId>& nearest) const {
  PointId best = hint.value_or(infinite_point);
  if (!hint) {
    const auto& forming = topology_.forming(locate(to, last_));
    best = forming[0] == infinite_point ? forming[1] : forming[0];
  }
  const auto compare_with_best = [&](PointId p) {
    return compare_distance(to, positions_[index(p)], positions_[index(best)]);
  };
  for (bool moved = true; moved;) {
    moved = false;
    for_each_neighbour(best, [&](PointId p) {
      if (moved || compare_with_best(p) >= 0) return;
      best = p;
      moved = true;
    });
  }
  nearest.push_back(best);
  for (std::size_t next = 0; next < nearest.size(); ++next) {
    for_each_neighbour(nearest[next], [&](PointId p) {
      if (compare_with_best(p) != 0) return;
      if (std::find(nearest.begin(), nearest.end(), p) == nearest.end()) nearest.push_back(p);
    });
  }
}

}  // namespace thiessen
