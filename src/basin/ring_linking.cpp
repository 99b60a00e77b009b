#include "basin/ring_linking.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "geometry/box.h"
#include "geometry/box_tree.h"
#include "geometry/predicates.h"
#include "geometry/ring_location.h"

namespace thiessen {
namespace {

struct PointHash {
  std::size_t operator()(Point p) const {
    const std::hash<double> hash;
    return hash(p.x) * 0x9E3779B97F4A7C15ull ^ hash(p.y);
  }
};

// The position of `p` on the way clockwise round `at` from the ray at→back: 0 to the right of the
// ray, 1 straight behind it, 2 to its left, 3 on it.
int clockwise_sector(Point at, Point back, Point p) {
  const int side = orientation(at, back, p);
  if (side < 0) return 0;
  if (side > 0) return 2;
  const bool same_way = (back.x - at.x) * (p.x - at.x) + (back.y - at.y) * (p.y - at.y) > 0;
  return same_way ? 3 : 1;
}

bool comes_first_clockwise(Point at, Point back, Point p, Point q) {
  const int p_sector = clockwise_sector(at, back, p);
  const int q_sector = clockwise_sector(at, back, q);
  if (p_sector != q_sector) return p_sector < q_sector;
  return orientation(at, p, q) < 0;
}

/// Walks along the edges and cuts the walk into rings that visit no point twice.
class RingWalk {
 public:
  /// Requires edges in their order by where they begin, then by where they end.
  explicit RingWalk(std::span<const DirectedEdge> edges)
      : edges_(edges), used_(edges.size(), false) {}

  std::vector<Ring> rings() && {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (!used_[i]) walk_from(i);
    }
    return std::move(rings_);
  }

 private:
  void walk_from(std::size_t first) {
    Ring path;
    bool branched = false;
    std::size_t i = first;
    while (!used_[i]) {
      used_[i] = true;
      path.push_back(edges_[i].from);
      const std::size_t next = next_edge(edges_[i], branched);
      if (next == edges_.size()) break;
      i = next;
    }
    if (branched) {
      part_at_repeated_points(path);
    } else if (path.size() > 2) {
      rings_.push_back(std::move(path));
    }
  }

  // The next unused edge. Where there are several, the first clockwise from the edge that leads
  // here keeps the interior, on the left, in one piece.
  std::size_t next_edge(const DirectedEdge& edge, bool& branched) const {
    const auto begin = std::lower_bound(edges_.begin(), edges_.end(), edge.to,
                                        [](const DirectedEdge& e, Point p) { return e.from < p; });
    std::size_t best = edges_.size();
    for (auto e = begin; e != edges_.end() && e->from == edge.to; ++e) {
      const auto i = static_cast<std::size_t>(e - edges_.begin());
      if (e != begin) branched = true;
      if (used_[i]) continue;
      if (best == edges_.size() ||
          comes_first_clockwise(edge.to, edge.from, e->to, edges_[best].to))
        best = i;
    }
    return best;
  }

  void part_at_repeated_points(const Ring& path) {
    Ring open;
    std::unordered_map<Point, std::size_t, PointHash> position;
    for (const Point p : path) {
      const auto found = position.find(p);
      if (found != position.end()) {
        const auto loop = open.begin() + static_cast<std::ptrdiff_t>(found->second);
        for (auto q = loop + 1; q != open.end(); ++q) position.erase(*q);
        if (open.end() - loop > 2) rings_.emplace_back(loop, open.end());
        open.erase(loop + 1, open.end());
        continue;
      }
      position.emplace(p, open.size());
      open.push_back(p);
    }
    if (open.size() > 2) rings_.push_back(std::move(open));
  }

  std::span<const DirectedEdge> edges_;
  std::vector<bool> used_;
  std::vector<Ring> rings_;
};

// The only ring of the edges, which are in their order; nothing where there are several, or where
// it touches itself. Most cells have one, of a few edges.
std::optional<Ring> only_ring(std::span<const DirectedEdge> edges) {
  const auto begins_alike = [](const DirectedEdge& a, const DirectedEdge& b) {
    return a.from == b.from;
  };
  if (edges.size() < 3 || std::ranges::adjacent_find(edges, begins_alike) != edges.end())
    return std::nullopt;
  Ring ring;
  ring.reserve(edges.size());
  auto edge = edges.begin();
  do {
    ring.push_back(edge->from);
    const auto next = std::ranges::lower_bound(edges, edge->to, {}, &DirectedEdge::from);
    if (next == edges.end() || next->from != edge->to) return std::nullopt;
    edge = next;
  } while (edge != edges.begin() && ring.size() < edges.size());
  const bool is_closed = edge == edges.begin() && ring.size() == edges.size();
  return is_closed ? std::optional(std::move(ring)) : std::nullopt;
}

double doubled_area_of(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    sum += (ring[i].x - ring[0].x) * (ring[i + 1].y - ring[0].y) -
           (ring[i].y - ring[0].y) * (ring[i + 1].x - ring[0].x);
  }
  return sum;
}

struct Shell {
  Box box;
  double area;
};

bool holds(const Polygon& part, const Ring& hole) {
  for (const Point p : hole) {
    const Where where = locate(part.outer, p);
    if (where != Where::boundary) return where == Where::inside;
  }
  return false;
}

// Puts each hole into the smallest part round it.
void place_holes(MultiPolygon& parts, const std::vector<Shell>& shells, std::vector<Ring>& holes) {
  if (holes.empty()) return;
  std::vector<Box> boxes;
  boxes.reserve(shells.size());
  for (const Shell& shell : shells) boxes.push_back(shell.box);
  const BoxTree tree(boxes);
  for (Ring& hole : holes) {
    const Box box = box_of(hole);
    std::size_t best = parts.size();
    tree.search(box, [&](std::uint32_t i) {
      if (!boxes[i].contains(box.low) || !boxes[i].contains(box.high)) return;
      if (best != parts.size() && shells[i].area >= shells[best].area) return;
      if (parts.size() == 1 || holds(parts[i], hole)) best = i;
    });
    if (best != parts.size()) parts[best].holes.push_back(std::move(hole));
  }
}

}  // namespace

MultiPolygon link_rings(std::span<DirectedEdge> edges) {
  std::ranges::sort(edges, [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  });
  MultiPolygon parts;
  if (std::optional<Ring> ring = only_ring(edges)) {
    if (doubled_area_of(*ring) > 0) parts.push_back({*std::move(ring), {}});
    return parts;
  }
  std::vector<Shell> shells;
  std::vector<Ring> holes;
  for (Ring& ring : RingWalk(edges).rings()) {
    const double area = doubled_area_of(ring);
    if (area > 0) {
      shells.push_back({box_of(ring), area});
      parts.push_back({std::move(ring), {}});
    } else if (area < 0) {
      holes.push_back(std::move(ring));
    }
  }
  place_holes(parts, shells, holes);
  return parts;
}

}  // namespace thiessen
