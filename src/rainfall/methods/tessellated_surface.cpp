#include "rainfall/methods/tessellated_surface.h"

#include <algorithm>
#include <array>

#include "geometry/predicates.h"

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

/// The mean of three values by their weights, of which rounding may have made some negative.
double weighted(const std::array<double, 3>& weights, const std::array<double, 3>& values) {
  double sum = 0;
  double total = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = std::max(0.0, weights[i]);
    sum += weight * values[i];
    total += weight;
  }
  return total > 0 ? sum / total : values[0];
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
  return kind() == ChartKind::plane ? in_plane_triangle(v, point.at) : on_earth(v, point.direction);
}

double LinearSurface::in_plane_triangle(VertexId v, Point point) const {
  const auto& corners = triangles().topology().forming(v);
  std::array<double, 3> weights{};
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = doubled_area(point, triangles().position(corners[after(i, 1)]),
                              triangles().position(corners[after(i, 2)]));
    values[i] = value_of(corners[i]);
  }
  return weighted(weights, values);
}

/// The larger, the earlier the line from the sphere's middle through x comes to the plane of the
/// triangle.
double LinearSurface::reach(VertexId v, Direction x) const {
  const auto& corners = triangles().topology().forming(v);
  const Direction a = natural().direction(corners[0]);
  const Direction across =
      cross(natural().direction(corners[1]) - a, natural().direction(corners[2]) - a);
  return dot(x, across) / dot(a, across);
}

/// By corner, in proportion to their weights at the point of the triangle's plane that is seen in
/// the direction x.
std::array<double, 3> LinearSurface::weights_seen(VertexId v, Direction x) const {
  const auto& corners = triangles().topology().forming(v);
  std::array<double, 3> weights{};
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = dot(x, cross(natural().direction(corners[after(i, 1)]) - x,
                              natural().direction(corners[after(i, 2)]) - x));
  }
  return weights;
}

/// The triangle behind a side that x lies beyond, to whose plane the line comes earlier; v where
/// there is none.
VertexId LinearSurface::earlier(VertexId v, const std::array<double, 3>& weights,
                                Direction x) const {
  const Topology<2>& topology = triangles().topology();
  const double reached = reach(v, x);
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId w = topology.neighbour(v, i);
    const bool is_hull = kind() != ChartKind::whole_earth && topology.is_infinite(w);
    if (weights[i] < 0 && !is_hull && reach(w, x) > reached) return w;
  }
  return v;
}

// Triangles of the chart have straight edges there, which are other circles of the sphere than the
// great ones between their corners. So the triangle of the chart is but the first. The flat
// triangles between gauges are faces of a convex body, and the line from the middle leaves it
// through the face whose plane it comes to first. Each step goes to a plane that it comes to
// earlier, so the walk ends, whatever is rounded.
double LinearSurface::on_earth(VertexId v, Direction x) const {
  for (;;) {
    const std::array<double, 3> weights = weights_seen(v, x);
    const VertexId next = earlier(v, weights, x);
    if (next == v) {
      const auto& corners = triangles().topology().forming(v);
      return weighted(weights, {value_of(corners[0]), value_of(corners[1]), value_of(corners[2])});
    }
    v = next;
  }
}

}  // namespace thiessen
