#include "basin/sphere_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "earth/sphere/conformal_sphere.h"
#include "geometry/segment.h"

namespace thiessen {
namespace {

/// The radius, in radians, of the disc round `centre`, the box's middle, that contains a box in
/// longitude and latitude.
double reach_of(const Box& box, Direction centre) {
  constexpr double widest = 90;  // degrees: up to there a corner is the farthest point
  if (box.width() > widest) return std::numbers::pi;
  double reach = 0;
  for (const Point corner :
       {box.low, box.high, Point{box.low.x, box.high.y}, Point{box.high.x, box.low.y}})
    reach = std::max(reach, 2 * std::asin(std::min(1.0, length(on_sphere(corner) - centre) / 2)));
  return reach;
}

}  // namespace

/// Turns rings of edges straight in longitude and latitude into rings of great circles.
class SphereShape::Simplifying {
 public:
  Simplifying(Direction centre, double tolerance, std::span<const Point> bends)
      : chart_(centre),
        surface_(chart_),
        farthest_off_(tolerance / scale_on_earth(centre.z)),
        bends_(bends) {}

  SphereRing ring(const Ring& ring, const std::vector<double>* bulges) {
    const auto is_corner = [this](Point p) {
      return !std::binary_search(bends_.begin(), bends_.end(), p);
    };
    keeps_all_ = std::count_if(ring.begin(), ring.end(), is_corner) < 3;
    const auto first = static_cast<std::size_t>(
        keeps_all_ ? 0 : std::find_if(ring.begin(), ring.end(), is_corner) - ring.begin());
    result_ = {};
    begin(on_sphere(ring[first]));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t from = (first + i) % ring.size();
      const std::size_t to = (from + 1) % ring.size();
      add_edge(ring[from], ring[to], bulges == nullptr ? 0 : (*bulges)[from]);
      if (keeps_all_ || i + 1 == ring.size() || is_corner(ring[to])) end_run();
    }
    return std::move(result_);
  }

 private:
  /// A point of a run: one between two corners that are kept, or one of the two.
  struct RunPoint {
    Direction direction;
    Point in_chart;
    /// From the chart's centre to the true edge, from the beginning of the run to this point.
    double area;
  };

  static double to_right(Point from, Point to, Point p) {
    const Point way{to.x - from.x, to.y - from.y};
    return ((p.x - from.x) * way.y - (p.y - from.y) * way.x) / std::hypot(way.x, way.y);
  }

  void begin(Direction corner) { run_.assign(1, {corner, chart_.project(corner), 0}); }

  // Adds to the run an edge that is straight in longitude and latitude.
  void add_edge(Point a, Point b, double bulge) {
    if (a == b) return;
    const Point from = run_.back().in_chart;
    const Point to = chart_.project(on_sphere(b));
    double farthest = 0;
    for (const BooleSample& x : boole_samples) {
      const Point p = chart_.project(on_sphere(between(a, b, x.along)));
      if (from != to) farthest = std::max(farthest, std::abs(to_right(from, to, p)));
    }
    constexpr double most_pieces = 1000;
    const int pieces = static_cast<int>(
        std::clamp(std::ceil(std::sqrt(farthest / farthest_off_)), 1.0, most_pieces));
    for (int i = 1; i <= pieces; ++i) {
      const double before = (i - 1.0) / pieces;
      const double after = static_cast<double>(i) / pieces;
      add_piece(between(a, b, before), i == pieces ? b : between(a, b, after),
                bulge * (bulge_share(after) - bulge_share(before)));
      if (pieces > 1 && i < pieces) end_run();
    }
  }

  void add_piece(Point a, Point b, double bulge) {
    const RunPoint before = run_.back();
    const Direction end = on_sphere(b);
    const Point to = chart_.project(end);
    if (to == before.in_chart) return;
    double mean = 0;
    for (const BooleSample& x : boole_samples) {
      const Point p = chart_.project(on_sphere(between(a, b, x.along)));
      mean += x.weight * to_right(before.in_chart, to, p);
    }
    const double length = std::hypot(to.x - before.in_chart.x, to.y - before.in_chart.y);
    const double off = mean * length * chart_.unit_area(between(before.in_chart, to, 0.5));
    run_.push_back({end, to, before.area + bulge + off - surface_.under(before.in_chart, to, 0)});
  }

  // Keeps the corner at which the run begins, and as many of the bends as the tolerance needs.
  void end_run() {
    if (run_.size() > 1) keep(0, run_.size() - 1);
    run_.erase(run_.begin(), run_.end() - 1);
    run_.front().area = 0;
  }

  void keep(std::size_t first, std::size_t last) {
    const RunPoint& from = run_[first];
    const RunPoint& to = run_[last];
    double farthest = 0;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = std::abs(to_right(from.in_chart, to.in_chart, run_[i].in_chart));
      if (off <= farthest) continue;
      farthest = off;
      at = i;
    }
    if (farthest > farthest_off_) {
      keep(first, at);
      keep(at, last);
      return;
    }
    result_.corners.push_back(from.direction);
    result_.bulges.push_back(to.area - from.area + surface_.under(from.in_chart, to.in_chart, 0));
  }

  GnomonicChart chart_;
  ChartSurface surface_;
  double farthest_off_;  // in the chart
  std::span<const Point> bends_;
  bool keeps_all_ = false;  // where too few would be left for a ring
  SphereRing result_;
  std::vector<RunPoint> run_;  // from the last corner that is kept
};

SphereShape::SphereShape(const Basin& ground, std::span<const Point> bends, double tolerance) {
  for (const Polygon& part : ground.shape) {
    for (const Point p : part.outer) box_.take_in(p);
  }
  centre_ = on_sphere(box_.centre());
  reach_ = reach_of(box_, centre_);
  if (reach_ > farthest_reach) return;
  Simplifying simplifying(centre_, tolerance, bends);
  std::size_t ring_number = 0;
  const auto ring = [&](const Ring& all) {
    return simplifying.ring(all, ground.bulges.empty() ? nullptr : &ground.bulges[ring_number++]);
  };
  for (const Polygon& part : ground.shape) {
    parts_.push_back({ring(part.outer), {}});
    for (const Ring& hole : part.holes) parts_.back().holes.push_back(ring(hole));
  }
}

Basin SphereShape::in_chart(const GnomonicChart& chart) const {
  Basin basin;
  const auto add = [&](const SphereRing& ring) {
    Ring projected;
    projected.reserve(ring.corners.size());
    for (const Direction corner : ring.corners) projected.push_back(chart.project(corner));
    basin.bulges.push_back(ring.bulges);
    return projected;
  };
  basin.shape.reserve(parts_.size());
  for (const Part& part : parts_) {
    Polygon polygon;
    polygon.outer = add(part.outer);
    for (const SphereRing& hole : part.holes) polygon.holes.push_back(add(hole));
    basin.shape.push_back(std::move(polygon));
  }
  return basin;
}

}  // namespace thiessen
