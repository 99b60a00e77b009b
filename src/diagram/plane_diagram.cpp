#include "diagram/plane_diagram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "diagram/needed_places.h"
#include "diagram/plane_centres.h"
#include "diagram/plane_sides.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The perpendicular bisector of two points, as a line with the first point's side to its left.
struct Bisector {
  Point middle;
  Point direction;

  // The direction is that from a to b turned left by a quarter, so that a is on its left.
  Bisector(Point a, Point b)
      : middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2}, direction{-(b.y - a.y), b.x - a.x} {}

  Point at(double t) const { return {middle.x + t * direction.x, middle.y + t * direction.y}; }
  double parameter_of(Point p) const {
    const double square = direction.x * direction.x + direction.y * direction.y;
    return ((p.x - middle.x) * direction.x + (p.y - middle.y) * direction.y) / square;
  }
};

struct Stretch {
  double from;
  double to;
};

/// The stretch of the line that is within the box, or nothing where the line misses the box.
std::optional<Stretch> within(const Box& box, const Bisector& line) {
  Stretch stretch{-infinity, infinity};
  const auto cut = [&](double start, double step, double low, double high) {
    if (step == 0) return low <= start && start <= high;
    double enter = (low - start) / step;
    double leave = (high - start) / step;
    if (enter > leave) std::swap(enter, leave);
    stretch = {std::max(stretch.from, enter), std::min(stretch.to, leave)};
    return stretch.from < stretch.to;
  };
  const bool meets = cut(line.middle.x, line.direction.x, box.low.x, box.high.x) &&
                     cut(line.middle.y, line.direction.y, box.low.y, box.high.y);
  return meets ? std::optional(stretch) : std::nullopt;
}

/// The nearest of the places; of equally near ones the lexicographically first.
PlaceIndex nearest_one_by_one(const std::vector<Point>& places, Point to) {
  std::size_t nearest = 0;
  double least = infinity;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Point way{places[i].x - to.x, places[i].y - to.y};
    const double square = way.x * way.x + way.y * way.y;
    if (square > least || (square == least && places[nearest] < places[i])) continue;
    least = square;
    nearest = i;
  }
  return PlaceIndex{static_cast<std::uint32_t>(nearest)};
}

class PlaneDiagramBuilder {
 public:
  PlaneDiagramBuilder(std::span<const Point> places, const Box& frame, const PlaneNeeds& needs)
      : needs_(needs), tessellation_(std::make_shared<Tessellation<2>>()) {
    const std::vector<PointId> points = tessellation_->add_all(places);
    place_of_->resize(tessellation_->topology().point_limit());
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      (*place_of_)[index(points[i])] = PlaceIndex{i};
      diagram_.cell_of.push_back(PlaceIndex{i});
    }
    const double margin = std::max(frame.width(), frame.height()) / 16;
    cutting_box_ = frame.grown(margin > 0 ? margin : largest_magnitude(frame) / 16 + 1);
    diagram_.frame = frame;
    diagram_.places.assign(places.begin(), places.end());
    find_inner_box();
    find_needed_points(points);
  }

  Diagram build() && {
    if (tessellation_->span() == Span::line) add_parallel_edges();
    if (tessellation_->span() == Span::plane) {
      centres_.emplace(*tessellation_, is_needed_);
      node_of_.assign(topology().size(), no_node);
      add_edges();
    }
    if (needs_.near_is_seldom) {
      diagram_.near = [places = diagram_.places](Point p) { return nearest_one_by_one(places, p); };
      return std::move(diagram_);
    }
    diagram_.near = [tessellation = tessellation_, place_of = place_of_](Point p) {
      return (*place_of)[index(*tessellation->nearest(p))];
    };
    return std::move(diagram_);
  }

 private:
  static double largest_magnitude(const Box& box) {
    return std::max(
        {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  }

  // What is computed of an edge is off by less than 2^-40 of the coordinates.
  void find_inner_box() {
    Box all = cutting_box_;
    for (const Point p : diagram_.places) all.take_in(p);
    const double margin = 0x1p-40 * largest_magnitude(all);
    inner_box_ = cutting_box_.grown(-margin);
  }

  Point position(PointId p) const { return tessellation_->position(p); }
  const Topology<2>& topology() const { return tessellation_->topology(); }

  void find_needed_points(const std::vector<PointId>& points) {
    const std::vector<bool> is_needed = needed_places(diagram_.places, needs_.ground);
    if (is_needed.empty()) return;
    is_needed_.assign(topology().point_limit(), false);
    for (std::size_t i = 0; i < points.size(); ++i) is_needed_[index(points[i])] = is_needed[i];
  }
  // An edge that meets ground is between two cells that do.
  bool is_needed(PointId a, PointId b) const {
    return is_needed_.empty() || (is_needed_[index(a)] && is_needed_[index(b)]);
  }

  void add_parallel_edges() {
    const std::vector<PointId> line = tessellation_->along_line();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      add_neighbours(line[i], line[i + 1]);
      add_edge(line[i], line[i + 1], no_vertex, no_vertex);
    }
  }

  // What is reserved and not used is never touched, and takes no memory.
  void add_edges() {
    const std::size_t edges = topology().size() / 2 * 3;
    if (needs_.neighbours) diagram_.neighbours.reserve(edges);
    diagram_.chords.reserve(edges);
    diagram_.nodes.reserve(topology().size());
    // The edge runs from the centre on the right of a→b to that on the left.
    for_each_joined_pair(topology(), [&](PointId a, PointId b, VertexId v, std::size_t side) {
      add_neighbours(a, b);
      if (is_needed(a, b)) add_edge(a, b, topology().neighbour(v, side), v);
    });
  }

  void add_neighbours(PointId a, PointId b) {
    if (!needs_.neighbours) return;
    diagram_.neighbours.emplace_back((*place_of_)[index(a)], (*place_of_)[index(b)]);
  }

  // Adds the edge between the cells of a and b, from `start` to `end`: the vertices to the right
  // and to the left of a→b, which are infinite or no_vertex where the edge has no end.
  void add_edge(PointId a, PointId b, VertexId start, VertexId end) {
    const bool starts = start != no_vertex && !topology().is_infinite(start);
    const bool ends = end != no_vertex && !topology().is_infinite(end);
    if (starts && ends && centres_->group_of(start) == centres_->group_of(end)) return;
    if (starts && ends && inner_box_.contains(centres_->of(start)) &&
        inner_box_.contains(centres_->of(end))) {
      add_edge_within(a, b, start, end);
      return;
    }
    // Always goes in one direction, so that rounding is the same for any order of places.
    if (position(b) < position(a)) {
      add_edge(b, a, end, start);
      return;
    }
    const Bisector line(position(a), position(b));
    const auto stretch = within(cutting_box_, line);
    if (!stretch) return;
    if (starts && line.parameter_of(centres_->of(start)) >= stretch->to) return;
    if (ends && line.parameter_of(centres_->of(end)) <= stretch->from) return;
    const std::uint32_t first = node_at(starts ? start : no_vertex, line.at(stretch->from));
    const std::uint32_t last = node_at(ends ? end : no_vertex, line.at(stretch->to));
    diagram_.chords.push_back({first, last, (*place_of_)[index(a)], (*place_of_)[index(b)]});
  }

  // Adds an edge whose ends are well within the box.
  void add_edge_within(PointId a, PointId b, VertexId start, VertexId end) {
    if (position(b) < position(a)) {
      std::swap(a, b);
      std::swap(start, end);
    }
    const std::uint32_t first = node_of(start);
    const std::uint32_t last = node_of(end);
    diagram_.chords.push_back({first, last, (*place_of_)[index(a)], (*place_of_)[index(b)]});
  }

  // The vertex's node. Where the centre is outside the box, it is a new node at which the edge
  // leaves the box, because the rounding of a far centre would turn the edge.
  std::uint32_t node_at(VertexId v, Point leaving) {
    if (v == no_vertex) return new_node(leaving);
    if (!cutting_box_.contains(centres_->of(v))) return new_node(leaving);
    return node_of(v);
  }
  std::uint32_t node_of(VertexId v) {
    std::uint32_t& node = node_of_[centres_->group_of(v)];
    if (node == no_node) node = new_node(centres_->of(v));
    return node;
  }

  std::uint32_t new_node(Point p) {
    diagram_.nodes.push_back(p);
    return static_cast<std::uint32_t>(diagram_.nodes.size() - 1);
  }

  const PlaneNeeds& needs_;
  std::vector<bool> is_needed_;  // by point; empty where all are
  std::shared_ptr<Tessellation<2>> tessellation_;
  std::shared_ptr<std::vector<PlaceIndex>> place_of_ = std::make_shared<std::vector<PlaceIndex>>();
  Box cutting_box_;
  Box inner_box_;  // far enough within that one for rounding not to count
  Diagram diagram_;
  std::optional<PlaneCentres> centres_;
  std::vector<std::uint32_t> node_of_;  // the node of each group of centres, or no_node
};

}  // namespace

Diagram plane_diagram(std::span<const Point> places, const Box& frame, const PlaneNeeds& needs) {
  return PlaneDiagramBuilder(places, frame, needs).build();
}

}  // namespace thiessen
