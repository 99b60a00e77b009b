#include "basin/containment.h"

#include <cmath>

#include "geometry/box_tree.h"
#include "geometry/ring_location.h"

namespace thiessen {

bool contains(const Basin& basin, Point p) {
  bool inside = false;
  const auto visit = [&](const Ring& ring) {
    const Where where = locate(ring, p);
    if (where == Where::inside) inside = !inside;
    return where == Where::boundary;
  };
  for (const Polygon& part : basin.shape) {
    if (visit(part.outer)) return true;
    for (const Ring& hole : part.holes) {
      if (visit(hole)) return true;
    }
  }
  return inside;
}

std::vector<std::size_t> count_within(const std::vector<Basin>& basins,
                                      std::span<const Point> points, double period) {
  std::vector<Box> boxes(basins.size());
  Box all;
  for (std::size_t b = 0; b < basins.size(); ++b) {
    for (const Polygon& part : basins[b].shape) boxes[b].take_in(box_of(part.outer));
    all.take_in(boxes[b]);
  }
  const BoxTree tree(boxes);
  std::vector<std::size_t> counts(basins.size(), 0);
  for (Point p : points) {
    const auto count_here = [&](std::uint32_t b) {
      if (contains(basins[b], p)) ++counts[b];
    };
    if (period > 0) p.x -= period * std::floor((p.x - all.low.x) / period);
    tree.search({p, p}, count_here);
  }
  return counts;
}

}  // namespace thiessen
