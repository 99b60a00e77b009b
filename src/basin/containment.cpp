#include "basin/containment.h"

#include <cmath>
#include <optional>

#include "base/interrupt.h"
#include "geometry/predicates.h"
#include "geometry/ring_location.h"

namespace thiessen {
namespace {

Box box_of(const Basin& basin) {
  Box box;
  for (const Polygon& part : basin.shape) box.take_in(box_of(part.outer));
  return box;
}

template <typename Edge>
std::vector<Edge> edges_of(const Basin& basin) {
  std::vector<Edge> edges;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
  };
  for (const Polygon& part : basin.shape) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
  return edges;
}

template <typename Edge>
std::vector<Box> boxes_of(const std::vector<Edge>& edges) {
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const Edge& edge : edges) boxes.push_back(box_of(edge.from, edge.to));
  return boxes;
}

}  // namespace

Containment::Containment(const Basin& basin)
    : edges_(edges_of<Edge>(basin)), tree_(boxes_of(edges_)), west_(box_of(basin).low.x) {}

bool Containment::contains(Point p) const {
  bool inside = false;
  bool on_edge = false;
  tree_.search({{west_, p.y}, p}, [&](std::uint32_t i) {
    const auto& [from, to] = edges_[i];
    const int side = orientation(from, to, p);
    if (side == 0 && box_of(from, to).contains(p)) on_edge = true;
    // An edge passes west of p if p lies to its right when it is followed upward.
    const bool upward = from.y < p.y;
    if (upward != (to.y < p.y) && (side < 0) == upward) inside = !inside;
  });
  return inside || on_edge;
}

std::vector<std::vector<std::size_t>> points_within(const std::vector<Basin>& basins,
                                                    std::span<const Point> points, double period) {
  std::vector<Box> boxes;
  boxes.reserve(basins.size());
  for (const Basin& basin : basins) boxes.push_back(box_of(basin));
  const BoxTree tree(boxes);
  std::vector<std::optional<Containment>> containments(basins.size());
  std::vector<std::vector<std::size_t>> within(basins.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    throw_if_interrupted();
    for (const int turn : {0, -1, 1}) {
      if (turn != 0 && !(period > 0)) break;
      const Point q{p.x + turn * period, p.y};
      tree.search({q, q}, [&](std::uint32_t b) {
        if (!containments[b]) containments[b].emplace(basins[b]);
        const bool is_known = !within[b].empty() && within[b].back() == i;
        if (!is_known && containments[b]->contains(q)) within[b].push_back(i);
      });
    }
  }
  return within;
}

std::vector<std::size_t> count_within(const std::vector<Basin>& basins,
                                      std::span<const Point> points, double period) {
  std::vector<std::size_t> counts;
  counts.reserve(basins.size());
  for (const auto& within : points_within(basins, points, period)) counts.push_back(within.size());
  return counts;
}

}  // namespace thiessen
