#include "rainfall/methods/natural_weights.h"

#include <cmath>

#include "tessellation/location.h"

namespace thiessen {

NaturalWeights::NaturalWeights(std::span<const ChartPoint> gauges, ChartKind kind) : kind_(kind) {
  std::vector<Point> positions;
  positions.reserve(gauges.size());
  for (const ChartPoint& gauge : gauges) {
    if (in_exact_range(gauge.at)) positions.push_back(gauge.at);
  }
  const std::vector<PointId> added = tessellation_.add_all(positions);
  auto next = added.begin();
  numbers_.reserve(gauges.size());
  for (const ChartPoint& gauge : gauges)
    numbers_.push_back(in_exact_range(gauge.at) ? *next++ : infinite_point);
  directions_.resize(tessellation_.topology().point_limit());
  for (std::size_t i = gauges.size(); i-- > 0;)
    directions_[index(numbers_[i])] = gauges[i].direction;
  take_vertices();
}

void NaturalWeights::take_vertices() {
  last_ = no_vertex;
  if (kind_ == ChartKind::whole_earth && tessellation_.span() == Span::plane)
    sphere_.take(tessellation_.topology(), directions_);
}

bool NaturalWeights::close_round_the_earth() const {
  if (tessellation_.span() != Span::plane) return false;
  bool close = true;
  tessellation_.topology().for_each_vertex([&](VertexId v) {
    const PointId corner = tessellation_.topology().forming(v)[0];
    close = close && dot(sphere_.centre_of(v), direction(corner)) > 0;
  });
  return close;
}

bool NaturalWeights::find(const ChartPoint& point, std::vector<NaturalWeight>& weights) {
  weights.clear();
  if (tessellation_.empty()) return false;
  if (!in_exact_range(point.at)) {
    if (kind_ == ChartKind::whole_earth) weights.push_back({infinite_point, 1});
    return kind_ == ChartKind::whole_earth;
  }
  const Topology<2>& topology = tessellation_.topology();
  const bool is_in_span =
      tessellation_.span() == Span::plane || !tessellation_.structure().is_off(point.at);
  if (!is_in_span) return false;
  if (tessellation_.span() == Span::point) {
    weights.push_back({topology.forming(tessellation_.structure().finite_vertex())[0], 1});
    return true;
  }
  if (tessellation_.span() == Span::plane) return find_in_plane(point, weights);
  const VertexId v = tessellation_.locate(point.at);
  const auto& ends = topology.forming(v);
  return find_on_edge(point.at, ends[0], ends[1], weights);
}

// Finds the weights on an edge of the hull, or on a piece of the line, that the point lies on. It
// returns false if the point lies beyond an end of the line.
bool NaturalWeights::find_on_edge(Point point, PointId a, PointId b,
                                  std::vector<NaturalWeight>& weights) const {
  for (const PointId p : {a, b}) {
    if (p == infinite_point || tessellation_.position(p) != point) continue;
    weights.push_back({p, 1});
    return true;
  }
  if (a == infinite_point || b == infinite_point) return false;
  const auto distance_to = [&](PointId p) {
    const Point at = tessellation_.position(p);
    return std::hypot(at.x - point.x, at.y - point.y);
  };
  const double from_a = distance_to(a);
  const double from_b = distance_to(b);
  weights.push_back({a, from_b / (from_a + from_b)});
  weights.push_back({b, from_a / (from_a + from_b)});
  return true;
}

bool NaturalWeights::find_in_plane(const ChartPoint& point, std::vector<NaturalWeight>& weights) {
  const Structure<2>& structure = tessellation_.structure();
  const Topology<2>& topology = structure.topology();
  if (last_ == no_vertex) last_ = topology.vertex_of(infinite_point);
  last_ = locate<2>(structure, point.at, last_);
  for (const PointId p : topology.forming(last_)) {
    if (p == infinite_point || structure.position(p) != point.at) continue;
    weights.push_back({p, 1});
    return true;
  }
  const bool has_hull = kind_ != ChartKind::whole_earth;
  if (has_hull && topology.is_infinite(last_)) return false;
  zone_.find<2>(structure, last_, point.at);
  for (const VertexId v : zone_.vertices()) {
    if (!has_hull) break;
    const std::size_t infinite = topology.corner_of(v, infinite_point);
    if (infinite == Topology<2>::corners) continue;
    const auto& forming = topology.forming(v);
    return find_on_edge(point.at, forming[(infinite + 1) % 3], forming[(infinite + 2) % 3],
                        weights);
  }
  if (kind_ == ChartKind::plane) {
    plane_.find(structure, zone_, point.at, stolen_);
  } else {
    sphere_.find(topology, zone_, directions_, point.direction, stolen_);
  }
  share_stolen(weights);
  return true;
}

void NaturalWeights::share_stolen(std::vector<NaturalWeight>& weights) {
  double total = 0;
  for (const StolenArea& stolen : stolen_) total += stolen.area;
  for (const StolenArea& stolen : stolen_) {
    if (stolen.area > 0) weights.push_back({stolen.gauge, stolen.area / total});
  }
}

}  // namespace thiessen
