#include "outlines/shape_tracing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "basin/ring_linking.h"
#include "outlines/ring_direction.h"

namespace thiessen {
namespace {

template <typename Visit>
void for_each_ring(MultiPolygon& shape, const Visit& visit) {
  for (Polygon& polygon : shape) {
    visit(polygon.outer, true);
    for (Ring& hole : polygon.holes) visit(hole, false);
  }
}

template <typename Visit>
void for_each_edge(const MultiPolygon& shape, const Visit& visit) {
  const auto ring = [&](const Ring& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
      visit(points[i], points[i + 1 < points.size() ? i + 1 : 0]);
  };
  for (const Polygon& polygon : shape) {
    ring(polygon.outer);
    std::for_each(polygon.holes.begin(), polygon.holes.end(), ring);
  }
}

/// Makes outer rings run counter-clockwise and holes clockwise, and turns their bulges with them.
void direct(CurvedShape& shape) {
  std::size_t number = 0;
  for_each_ring(shape.shape, [&](Ring& ring, bool outer) {
    const std::size_t i = number++;
    if ((signed_area(ring) > 0) == outer) return;
    std::reverse(ring.begin() + 1, ring.end());
    if (shape.bulges.empty()) return;
    std::reverse(shape.bulges[i].begin(), shape.bulges[i].end());
    for (double& bulge : shape.bulges[i]) bulge = -bulge;
  });
}

/// The seam of a shape in degrees that is cut at the antimeridian: whether it touches the poles and
/// the antimeridian, where one place of the Earth is several points.
struct Seam {
  bool south = false;
  bool north = false;
  bool antimeridian = false;

  bool any() const { return south || north || antimeridian; }
};

Seam seam_of(const MultiPolygon& shape) {
  Seam seam;
  for_each_edge(shape, [&](Point a, Point) {
    seam.south = seam.south || a.y == -90;
    seam.north = seam.north || a.y == 90;
    seam.antimeridian = seam.antimeridian || std::abs(a.x) == 180;
  });
  return seam;
}

/// The edges of a shape that is cut at the antimeridian, without its seam.
std::vector<DirectedEdge> edges_without_seam(const MultiPolygon& shape) {
  std::vector<DirectedEdge> edges;
  // By latitude on the antimeridian: northward edges that begin there minus those that end there.
  std::map<double, int> northward;
  for_each_edge(shape, [&](Point a, Point b) {
    if (a.y == b.y && std::abs(a.y) == 90) return;
    if (a.x == b.x && std::abs(a.x) == 180) {
      ++northward[a.y];
      --northward[b.y];
    } else {
      edges.push_back({a, b});
      for (const Point point : {a, b}) {
        if (std::abs(point.x) == 180) northward[point.y] += 0;
      }
    }
  });
  int times = 0;
  for (auto at = northward.begin(); at != northward.end() && std::next(at) != northward.end();
       ++at) {
    times += at->second;
    const Point low{180, at->first};
    const Point high{180, std::next(at)->first};
    for (int i = 0; i < times; ++i) edges.push_back({low, high});
    for (int i = times; i < 0; ++i) edges.push_back({high, low});
  }
  return edges;
}

void leave_out(const std::set<Point>& points, MultiPolygon& shape) {
  for_each_ring(shape, [&](Ring& ring, bool) {
    std::erase_if(ring, [&](Point point) { return points.contains(point); });
  });
}

double doubled_area(const std::vector<DirectedEdge>& edges) {
  double sum = 0;
  const Point origin = edges.front().from;
  for (const auto& [a, b] : edges)
    sum += (a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y);
  return sum;
}

}  // namespace

ShapeTracer::ShapeTracer(std::shared_ptr<const Mapping> mapping, PlanePoles poles,
                         double chord_error, Course course)
    : mapping_(std::move(mapping)),
      tracer_(*mapping_, std::move(poles), chord_error, course),
      from_degrees_(mapping_->from().in_degrees()),
      to_degrees_(mapping_->to().in_degrees()),
      metres_per_unit_(mapping_->to().metres_per_unit()) {}

std::optional<CurvedShape> ShapeTracer::trace(const MultiPolygon& shape, Longitudes longitudes) {
  if (to_degrees_) return to_degrees(shape, longitudes);
  return from_degrees_ ? from_degrees(shape, nullptr) : ring_by_ring(shape);
}

std::optional<CurvedShape> ShapeTracer::trace_without_cuts(const MultiPolygon& shape,
                                                           const std::set<double>& own) {
  return from_degrees_ && !to_degrees_ ? from_degrees(shape, &own)
                                       : trace(shape, Longitudes::run_on);
}

std::optional<CurvedShape> ShapeTracer::from_degrees(const MultiPolygon& shape,
                                                     const std::set<double>* own) {
  CurvedShape cut{shape, {}};
  cut_at_antimeridian(cut);
  if (!seam_of(cut.shape).any()) return ring_by_ring(cut.shape);
  if (!reaches_poles(cut.shape)) return std::nullopt;
  auto whole = joined(cut.shape, own);
  return whole ? std::move(whole) : ring_by_ring(cut.shape);
}

std::optional<CurvedShape> ShapeTracer::to_degrees(const MultiPolygon& shape,
                                                   Longitudes longitudes) {
  CurvedShape result;
  for (const Polygon& polygon : shape) {
    std::vector<WindingRing> rings;
    const auto add = [&](const Ring& ring) {
      auto traced = tracer_.trace(ring);
      if (!traced) {
        outside_ = tracer_.outside();
        return false;
      }
      outside_ = ring.front();
      rings.push_back(*std::move(traced));
      return true;
    };
    if (!add(polygon.outer) || !std::all_of(polygon.holes.begin(), polygon.holes.end(), add))
      return std::nullopt;
    if (!add_polygon(std::move(rings), longitudes, result).empty()) return std::nullopt;
  }
  direct(result);
  return result;
}

/// Whether the projection reaches the poles that a shape in degrees touches. Mercator's gives a
/// finite point for a pole, far beyond all others, which does not count.
bool ShapeTracer::reaches_poles(const MultiPolygon& shape) {
  const Seam seam = seam_of(shape);
  for (const double sign : {-1.0, 1.0}) {
    if (!(sign < 0 ? seam.south : seam.north)) continue;
    const auto pole = (*mapping_)(Point{0, 90 * sign});
    const auto beside = (*mapping_)(Point{0, 89.9999999 * sign});
    constexpr double far = 1000;  // metres, where 0.01 would be true to scale
    outside_ = {0, 90 * sign};
    if (!pole || !beside) return false;
    if (std::hypot(pole->x - beside->x, pole->y - beside->y) * metres_per_unit_ > far) return false;
  }
  return true;
}

std::optional<CurvedShape> ShapeTracer::joined(const MultiPolygon& shape,
                                               const std::set<double>* own) {
  const std::vector<DirectedEdge> in_degrees = edges_without_seam(shape);
  auto edges = tracer_.trace(in_degrees);
  if (!edges || edges->empty()) return std::nullopt;
  if (doubled_area(*edges) < 0) {
    for (DirectedEdge& edge : *edges) std::swap(edge.from, edge.to);
  }
  std::erase_if(*edges, [](const DirectedEdge& edge) { return edge.from == edge.to; });
  CurvedShape result{link_rings(*std::move(edges)), {}};
  if (own != nullptr) leave_out(cuts_of(in_degrees, *own), result.shape);
  return result;
}

/// The positions, in the target, of the vertices that cutting made.
std::set<Point> ShapeTracer::cuts_of(const std::vector<DirectedEdge>& edges,
                                     const std::set<double>& own) const {
  std::vector<Point> cuts;
  for (const DirectedEdge& edge : edges) {
    if (std::abs(edge.from.x) == 180 && !own.contains(edge.from.y))
      cuts.push_back({180, edge.from.y});
  }
  mapping_->apply_unproved(cuts);
  return {cuts.begin(), cuts.end()};
}

std::optional<CurvedShape> ShapeTracer::ring_by_ring(const MultiPolygon& shape) {
  CurvedShape result{shape, {}};
  bool inside = true;
  for_each_ring(result.shape, [&](Ring& ring, bool) {
    auto traced = inside ? tracer_.trace(ring) : std::nullopt;
    inside = traced.has_value();
    if (inside) ring = std::move(traced->points);
  });
  if (!inside) {
    outside_ = tracer_.outside();
    return std::nullopt;
  }
  turn_rings(result.shape);
  return result;
}

}  // namespace thiessen
