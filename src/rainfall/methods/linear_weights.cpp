#include "rainfall/methods/linear_weights.h"

#include <algorithm>
#include <cstddef>

#include "geometry/predicates.h"

namespace thiessen {
namespace {

using Corners = std::array<double, 3>;

constexpr std::size_t after(std::size_t corner, std::size_t steps) {
  return (corner + steps) % 3;
}

/// The weights of a triangle's corners, of which rounding may have made some negative.
std::array<NaturalWeight, 3> of_corners(const NaturalWeights& gauges, VertexId v,
                                        const Corners& weights) {
  const auto& corners = gauges.tessellation().topology().forming(v);
  std::array<NaturalWeight, 3> weighed{};
  double total = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    weighed[i] = {corners[i], std::max(0.0, weights[i])};
    total += weighed[i].weight;
  }
  if (!(total > 0)) weighed[0].weight = 1;
  return weighed;
}

Corners weights_in_plane(const NaturalWeights& gauges, VertexId v, Point point) {
  const auto& corners = gauges.tessellation().topology().forming(v);
  Corners weights{};
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = doubled_area(point, gauges.tessellation().position(corners[after(i, 1)]),
                              gauges.tessellation().position(corners[after(i, 2)]));
  }
  return weights;
}

/// The larger, the earlier the line from the sphere's middle through x comes to the plane of the
/// triangle.
double reach(const NaturalWeights& gauges, VertexId v, Direction x) {
  const auto& corners = gauges.tessellation().topology().forming(v);
  const Direction a = gauges.direction(corners[0]);
  const Direction across =
      cross(gauges.direction(corners[1]) - a, gauges.direction(corners[2]) - a);
  return dot(x, across) / dot(a, across);
}

/// By corner, in proportion to their weights at the point of the triangle's plane that is seen in
/// the direction x.
Corners weights_seen(const NaturalWeights& gauges, VertexId v, Direction x) {
  const auto& corners = gauges.tessellation().topology().forming(v);
  Corners weights{};
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = dot(x, cross(gauges.direction(corners[after(i, 1)]) - x,
                              gauges.direction(corners[after(i, 2)]) - x));
  }
  return weights;
}

/// The triangle behind a side that x lies beyond, to whose plane the line comes earlier; v where
/// there is none.
VertexId earlier(const NaturalWeights& gauges, VertexId v, const Corners& weights, Direction x) {
  const Topology<2>& topology = gauges.tessellation().topology();
  const double reached = reach(gauges, v, x);
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId w = topology.neighbour(v, i);
    const bool is_hull = gauges.kind() != ChartKind::whole_earth && topology.is_infinite(w);
    if (weights[i] < 0 && !is_hull && reach(gauges, w, x) > reached) return w;
  }
  return v;
}

}  // namespace

// Triangles of the chart have straight edges there, which are other circles of the sphere than the
// great ones between their corners. So the triangle of the chart is but the first. The flat
// triangles between gauges are faces of a convex body, and the line from the middle leaves it
// through the face whose plane it comes to first. Each step goes to a plane that it comes to
// earlier, so the walk ends, whatever is rounded.
std::array<NaturalWeight, 3> linear_weights(const NaturalWeights& gauges, VertexId v,
                                            const ChartPoint& point) {
  if (gauges.kind() == ChartKind::plane)
    return of_corners(gauges, v, weights_in_plane(gauges, v, point.at));
  for (;;) {
    const Corners weights = weights_seen(gauges, v, point.direction);
    const VertexId next = earlier(gauges, v, weights, point.direction);
    if (next == v) return of_corners(gauges, v, weights);
    v = next;
  }
}

}  // namespace thiessen
