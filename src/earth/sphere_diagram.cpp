#include "earth/sphere_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "earth/arc_drawing.h"
#include "earth/bisector_arc.h"
#include "earth/conformal_sphere.h"
#include "earth/sphere_tessellation.h"

namespace thiessen {
namespace {

constexpr double pi = std::numbers::pi;
// Centres of triangles are right to some 1e-15 radians, thin triangles' to more: 0.6 micrometres.
constexpr double indistinct = 1e-13;

class SphereDiagramBuilder {
 public:
  SphereDiagramBuilder(std::span<const Point> places, const Box& frame, double tolerance)
      : sphere_(std::make_shared<SphereTessellation>(places)) {
    diagram_.frame = frame;
    diagram_.period = 360;
    diagram_.places.assign(places.begin(), places.end());
    diagram_.cell_of = sphere_->cell_of();
    diagram_.near = [sphere = sphere_](Point p) { return sphere->nearest(on_sphere(p)); };
    drawing_.emplace(diagram_, tolerance);
  }

  Diagram build() && {
    switch (tessellation().span()) {
      case Span::nothing:
        break;
      case Span::point:
        add_great_circle();
        break;
      case Span::line:
        add_half_circles();
        break;
      case Span::plane:
      case Span::space:
        add_edges();
        break;
    }
    return std::move(diagram_);
  }

 private:
  const Tessellation<2>& tessellation() const { return sphere_->tessellation(); }
  PlaceIndex place(PointId p) const { return sphere_->place(p); }
  Direction direction(PointId p) const { return sphere_->direction(place(p)); }
  Point position(PointId p) const { return diagram_.places[index(place(p))]; }

  // From a to b. The difference of directions has their rounding, which turns a chord of length s
  // by 1e-16 / s: it is taken only where that is below `turned_at_most`.
  Direction chord(PointId a, PointId b, double turned_at_most) const {
    const Direction difference = direction(b) - direction(a);
    const double shortest = 1e-16 / turned_at_most;
    return dot(difference, difference) > shortest * shortest
               ? difference
               : chord_on_sphere(position(a), position(b));
  }
  BisectorArc bisector(PointId a, PointId b) const {
    return {direction(a), direction(b), chord(a, b, 1e-12)};
  }
  Direction centre(PointId a, PointId b, PointId c) const {
    return unit(cross(chord(a, b, 1e-15), chord(a, c, 1e-15)));
  }

  // One other place: the edge closes on itself.
  void add_great_circle() {
    const PointId other = tessellation().along_line().front();
    const BisectorArc arc = bisector(infinite_point, other);
    const Point start = drawing_->position_of(arc.at(pi));
    const std::uint32_t node = drawing_->new_node(start);
    drawing_->draw(arc, {-pi, node, start}, {pi, node, start}, place(infinite_point), place(other));
  }

  // All on one circle with the pole: the edges meet in the circle's two centres. Going round the
  // circle counter-clockwise as seen from `middle`, that is the left one.
  void add_half_circles() {
    std::vector<PointId> ring = tessellation().along_line();
    ring.push_back(infinite_point);
    if (position(ring[ring.size() - 2]) < position(ring[0]))
      std::reverse(ring.begin(), ring.end() - 1);
    const Direction middle = centre(ring[0], ring[1], ring.back());
    const Vertex left = vertex_at(middle);
    const Vertex right = vertex_at(-1.0 * middle);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      add_edge(ring[i], ring[(i + 1) % ring.size()], right, left);
    }
  }

  void add_edges() {
    const Topology<2>& topology = tessellation().topology();
    find_centres();
    topology.for_each_vertex([&](VertexId v) {
      for (std::size_t side = 0; side < 3; ++side) {
        const VertexId w = topology.neighbour(v, side);
        if (w < v || centre_at(w).node == centre_at(v).node) continue;
        const auto& forming = topology.forming(v);
        add_edge(forming[(side + 1) % 3], forming[(side + 2) % 3], centre_at(w), centre_at(v));
      }
    });
  }

  // Neighbouring vertices that rounding cannot tell apart, as those of four gauges on a grid, are
  // one: the first of them by its forming points' coordinates.
  void find_centres() {
    const Topology<2>& topology = tessellation().topology();
    centres_.resize(topology.size());
    same_as_.resize(topology.size());
    std::iota(same_as_.begin(), same_as_.end(), 0u);
    topology.for_each_vertex([&](VertexId v) { centres_[index(v)] = {centre_of(v), {}, no_node}; });
    topology.for_each_vertex([&](VertexId v) {
      for (std::size_t side = 0; side < 3; ++side) {
        const VertexId w = topology.neighbour(v, side);
        const Direction apart = centres_[index(v)].direction - centres_[index(w)].direction;
        if (w > v && dot(apart, apart) <= indistinct * indistinct) unite(index(v), index(w));
      }
    });
    topology.for_each_vertex([&](VertexId v) {
      if (find(index(v)) == index(v)) centres_[index(v)] = vertex_at(centres_[index(v)].direction);
    });
  }

  void unite(std::size_t i, std::size_t j) {
    const std::uint32_t a = find(i);
    const std::uint32_t b = find(j);
    if (a == b) return;
    const bool keeps_a = corners_of(VertexId{a}) < corners_of(VertexId{b});
    same_as_[keeps_a ? b : a] = keeps_a ? a : b;
  }
  std::uint32_t find(std::size_t i) {
    auto v = static_cast<std::uint32_t>(i);
    while (same_as_[v] != v) v = same_as_[v] = same_as_[same_as_[v]];
    return v;
  }
  std::array<Point, 3> corners_of(VertexId v) const {
    const auto& f = tessellation().topology().forming(v);
    std::array<Point, 3> corners{position(f[0]), position(f[1]), position(f[2])};
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  // From the first forming point by coordinates on, so that rounding is the same for any order of
  // places.
  Direction centre_of(VertexId v) const {
    auto forming = tessellation().topology().forming(v);
    const auto first = std::min_element(forming.begin(), forming.end(), [&](PointId a, PointId b) {
      return position(a) < position(b);
    });
    std::rotate(forming.begin(), first, forming.end());
    return centre(forming[0], forming[1], forming[2]);
  }

  struct Vertex {
    Direction direction;
    Point position;
    std::uint32_t node;
  };
  const Vertex& centre_at(VertexId v) { return centres_[find(index(v))]; }
  Vertex vertex_at(Direction d) {
    const Point position = drawing_->position_of(d);
    return {d, position, drawing_->new_node(position)};
  }

  void add_edge(PointId a, PointId b, const Vertex& start, const Vertex& end) {
    if (position(b) < position(a)) {
      add_edge(b, a, end, start);
      return;
    }
    const BisectorArc arc = bisector(a, b);
    const double from = arc.angle_of(start.direction);
    // No edge is longer than half a circle, so a turn far backward is one forward; a little
    // backward is rounding.
    double turn = std::remainder(arc.angle_of(end.direction) - from, 2 * pi);
    if (turn < -pi / 2) turn += 2 * pi;
    turn = std::max(turn, 0.0);
    drawing_->draw(arc, {from, start.node, start.position}, {from + turn, end.node, end.position},
                   place(a), place(b));
  }

  std::shared_ptr<const SphereTessellation> sphere_;
  Diagram diagram_;
  std::optional<ArcDrawing> drawing_;
  std::vector<Vertex> centres_;  // by vertex, as what follows
  std::vector<std::uint32_t> same_as_;
};

}  // namespace

Diagram sphere_diagram(std::span<const Point> places, const Box& frame, double tolerance) {
  return SphereDiagramBuilder(places, frame, tolerance).build();
}

}  // namespace thiessen
