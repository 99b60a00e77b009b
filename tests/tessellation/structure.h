#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "geometry/predicates.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// A simplex by its points' positions, which no order of insertion changes: the infinite point is
/// (infinity, infinity), and the least comes first.
using PlainSimplex = std::array<Point, 3>;

inline std::set<PlainSimplex> plain_simplices(const Tessellation& tessellation) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::set<PlainSimplex> simplices;
  if (tessellation.span() != Span::plane) return simplices;
  const Topology<2>& topology = tessellation.topology();
  for (std::uint32_t i = 0; i < topology.size(); ++i) {
    if (topology.is_free(VertexId{i})) continue;
    PlainSimplex simplex;
    for (std::size_t k = 0; k < 3; ++k) {
      const PointId p = topology.forming(VertexId{i})[k];
      simplex.at(k) = p == infinite_point ? Point{infinity, infinity} : tessellation.position(p);
    }
    std::rotate(simplex.begin(), std::min_element(simplex.begin(), simplex.end()), simplex.end());
    simplices.insert(simplex);
  }
  return simplices;
}

/// The nearest of the points, the first by coordinates of equally near ones, by looking at each.
inline std::optional<Point> nearest_one_by_one(std::span<const Point> points, Point to) {
  std::optional<Point> best;
  for (const Point p : points) {
    const int order = best ? compare_distance(to, p, *best) : -1;
    if (order < 0 || (order == 0 && p < *best)) best = p;
  }
  return best;
}

}  // namespace thiessen
