#include "rainfall/methods/tessellated_surface.h"

#include <algorithm>

#include "geometry/predicates.h"
#include "rainfall/methods/linear_weights.h"

namespace thiessen {
namespace {

std::vector<ChartPoint> charted(const std::vector<Point>& positions, const GaugeChart& chart) {
  std::vector<ChartPoint> points;
  points.reserve(positions.size());
  for (const Point p : positions) points.push_back(chart.at(p));
  return points;
}

/// The mean value of the gauges that have each number: several where rounding cannot tell them
/// apart.
std::vector<double> values_by_number(std::span<const PointId> numbers,
                                     std::span<const double> values) {
  std::vector<double> sums;
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t number = index(numbers[i]);
    if (number >= sums.size()) {
      sums.resize(number + 1, 0);
      counts.resize(number + 1, 0);
    }
    sums[number] += values[i];
    ++counts[number];
  }
  for (std::size_t n = 0; n < sums.size(); ++n) {
    if (counts[n] > 0) sums[n] /= static_cast<double>(counts[n]);
  }
  return sums;
}

constexpr std::size_t after(std::size_t corner, std::size_t steps) {
  return (corner + steps) % 3;
}

}  // namespace

TessellatedSurface::TessellatedSurface(const SurfaceGauges& gauges, Metric metric)
    : chart_(gauges.at, metric),
      natural_(charted(gauges.at, chart_), chart_.kind()),
      values_(values_by_number(natural_.numbers(), gauges.values)),
      nearest_(gauges.at, metric),
      gauge_values_(gauges.values) {}

void TessellatedSurface::begin_anew() {
  natural_.begin_anew();
  last_.reset();
}

RainSurface::Value TessellatedSurface::at(Point position) {
  const std::optional<double> value = among_gauges(chart_.at(position));
  return value ? Value{*value, true} : Value{nearest_value(position), false};
}

RainSurface::Value TessellatedSurface::continued(Point position) {
  const ChartPoint point = chart_.at(position);
  if (const std::optional<double> value = among_gauges(point)) return {*value, true};
  if (triangles().span() != Span::plane || !in_exact_range(point.at))
    return {nearest_value(position), false};
  const OnHull edge = nearest_on_hull(point.at);
  const std::optional<double> inside = value_at_mirror(point.at, edge, 1);
  if (!inside) return {edge.value, false};
  if (tends_to_edge()) return {2 * edge.value - *inside, false};
  const std::optional<double> deeper = value_at_mirror(point.at, edge, 3);
  return {deeper ? 2 * *inside - *deeper : *inside, false};
}

/// The value so many times as far within the hull as the point is beyond its edge, if that is
/// within.
std::optional<double> TessellatedSurface::value_at_mirror(Point point, const OnHull& edge,
                                                          double times) {
  const Point within{edge.at.x + times * (edge.at.x - point.x),
                     edge.at.y + times * (edge.at.y - point.y)};
  return among_gauges(chart_.found_at(within));
}

double TessellatedSurface::nearest_value(Point position) {
  nearest_.find(position, 1, {}, near_);
  return gauge_values_[index(near_.front().place)];
}

std::optional<double> TessellatedSurface::natural_value(const ChartPoint& point) {
  if (!natural_.find(point, weights_)) return {};
  double sum = 0;
  double total = 0;
  for (const NaturalWeight& w : weights_) {
    sum += w.weight * value_of(w.gauge);
    total += w.weight;
  }
  return sum / total;
}

VertexId TessellatedSurface::locate(Point in_chart) {
  const VertexId v = triangles().locate(in_chart, last_);
  for (const PointId p : triangles().topology().forming(v)) {
    if (p != infinite_point) last_ = p;
  }
  return v;
}

TessellatedSurface::OnHull TessellatedSurface::nearest_on_edge(VertexId outside,
                                                               Point point) const {
  const Topology<2>& topology = triangles().topology();
  const std::size_t infinite = topology.corner_of(outside, infinite_point);
  const PointId a = topology.forming(outside)[after(infinite, 1)];
  const PointId b = topology.forming(outside)[after(infinite, 2)];
  const Point from = triangles().position(a);
  const Point to = triangles().position(b);
  const Point edge{to.x - from.x, to.y - from.y};
  const double along = ((point.x - from.x) * edge.x + (point.y - from.y) * edge.y) /
                       (edge.x * edge.x + edge.y * edge.y);
  const double share = std::clamp(along, 0.0, 1.0);
  const Point at{from.x + share * edge.x, from.y + share * edge.y};
  const Point apart{point.x - at.x, point.y - at.y};
  return {at, (1 - share) * value_of(a) + share * value_of(b),
          apart.x * apart.x + apart.y * apart.y};
}

// From an edge that is seen from the point, edges come nearer and then go away, in both directions,
// for the hull is convex.
TessellatedSurface::OnHull TessellatedSurface::nearest_on_hull(Point point) {
  const Topology<2>& topology = triangles().topology();
  const VertexId seen = locate(point);
  OnHull nearest = nearest_on_edge(seen, point);
  for (const std::size_t direction : {1UL, 2UL}) {
    VertexId v = seen;
    for (;;) {
      v = topology.neighbour(v, after(topology.corner_of(v, infinite_point), direction));
      const OnHull next = nearest_on_edge(v, point);
      if (next.square >= nearest.square) break;
      nearest = next;
    }
  }
  return nearest;
}

std::optional<double> LinearSurface::among_gauges(const ChartPoint& point) {
  const bool has_hull = kind() != ChartKind::whole_earth;
  // On a line natural neighbours are linear already, and at infinity there is one gauge or none.
  if (triangles().span() != Span::plane || !in_exact_range(point.at)) return natural_value(point);
  const VertexId v = locate(point.at);
  if (has_hull && triangles().topology().is_infinite(v)) return {};
  double sum = 0;
  double total = 0;
  for (const NaturalWeight& w : linear_weights(natural(), v, point)) {
    sum += w.weight * value_of(w.gauge);
    total += w.weight;
  }
  return sum / total;
}

}  // namespace thiessen
