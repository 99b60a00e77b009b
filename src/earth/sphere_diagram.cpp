#include "earth/sphere_diagram.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "earth/cell_edge.h"
#include "earth/conformal_sphere.h"
#include "earth/edge_drawing.h"
#include "earth/sphere_tessellation.h"
#include "geometry/disjoint_sets.h"

namespace thiessen {
namespace {

constexpr double pi = std::numbers::pi;
// Centres of triangles are right to some 1e-15 radians, thin triangles' to more: 0.6 micrometres.
constexpr double indistinct = 1e-13;

class SphereDiagramBuilder {
 public:
  SphereDiagramBuilder(std::span<const Point> places, const Box& frame, double tolerance)
      : sphere_(std::make_shared<SphereTessellation>(places)),
        tolerance_(tolerance),
        longitudes_(frame) {
    diagram_.frame = frame;
    diagram_.period = 360;
    diagram_.places.assign(places.begin(), places.end());
    diagram_.cell_of = sphere_->cell_of();
    diagram_.near = [sphere = sphere_](Point p) { return sphere->nearest(on_sphere(p)); };
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
    if (drawing_) drawing_->add_to(diagram_);
    return std::move(diagram_);
  }

 private:
  const Tessellation<2>& tessellation() const { return sphere_->tessellation(); }
  PlaceIndex place(PointId p) const { return sphere_->place(p); }
  Point position(PointId p) const { return diagram_.places[index(place(p))]; }
  GreatCircleEdge edge(PointId a, PointId b) const {
    return GreatCircleEdge(sphere_->bisector(place(a), place(b)));
  }

  // One other place: the edge closes on itself.
  void add_great_circle() {
    const PointId other = tessellation().along_line().front();
    const GreatCircleEdge circle = edge(infinite_point, other);
    const Vertex start = vertex_at(circle.arc().at(pi));
    begin_drawing();
    drawing_->draw(circle, {-pi, start.node, start.position}, {pi, start.node, start.position},
                   place(infinite_point), place(other));
  }

  // All on one circle with the pole: the edges meet in the circle's two centres. Going round the
  // circle counter-clockwise as seen from `middle`, that is the left one.
  void add_half_circles() {
    std::vector<PointId> ring = tessellation().along_line();
    ring.push_back(infinite_point);
    if (position(ring[ring.size() - 2]) < position(ring[0]))
      std::reverse(ring.begin(), ring.end() - 1);
    const Direction middle = sphere_->centre(place(ring[0]), place(ring[1]), place(ring.back()));
    const Vertex left = vertex_at(middle);
    const Vertex right = vertex_at(-1.0 * middle);
    begin_drawing();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      add_edge(ring[i], ring[(i + 1) % ring.size()], right, left);
    }
  }

  void add_edges() {
    const Topology<2>& topology = tessellation().topology();
    find_centres();
    begin_drawing();
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
    groups_.emplace(topology.size());
    topology.for_each_vertex([&](VertexId v) { centres_[index(v)] = {centre_of(v), {}, no_node}; });
    topology.for_each_vertex([&](VertexId v) {
      for (std::size_t side = 0; side < 3; ++side) {
        const VertexId w = topology.neighbour(v, side);
        const Direction apart = centres_[index(v)].direction - centres_[index(w)].direction;
        if (w > v && dot(apart, apart) <= indistinct * indistinct) unite(index(v), index(w));
      }
    });
    topology.for_each_vertex([&](VertexId v) {
      if (groups_->find(index(v)) == index(v))
        centres_[index(v)] = vertex_at(centres_[index(v)].direction);
    });
  }

  void unite(std::size_t i, std::size_t j) {
    const std::uint32_t a = groups_->find(i);
    const std::uint32_t b = groups_->find(j);
    if (a == b) return;
    const bool keeps_a =
        sphere_->key_of(corners_of(VertexId{a})) < sphere_->key_of(corners_of(VertexId{b}));
    groups_->unite(keeps_a ? a : b, keeps_a ? b : a);
  }
  std::array<PlaceIndex, 3> corners_of(VertexId v) const {
    const auto& f = tessellation().topology().forming(v);
    return {place(f[0]), place(f[1]), place(f[2])};
  }
  Direction centre_of(VertexId v) const {
    const auto [a, b, c] = sphere_->in_order(corners_of(v));
    return sphere_->centre(a, b, c);
  }

  struct Vertex {
    Direction direction;
    Point position;
    std::uint32_t node;
  };
  const Vertex& centre_at(VertexId v) { return centres_[groups_->find(index(v))]; }
  Vertex vertex_at(Direction d) {
    const Point position = longitudes_.within(from_sphere(d));
    diagram_.nodes.push_back(position);
    return {d, position, static_cast<std::uint32_t>(diagram_.nodes.size() - 1)};
  }
  // Once all vertices have their nodes.
  void begin_drawing() {
    drawing_.emplace(diagram_.frame, tolerance_, static_cast<std::uint32_t>(diagram_.nodes.size()));
  }

  void add_edge(PointId a, PointId b, const Vertex& start, const Vertex& end) {
    if (position(b) < position(a)) {
      add_edge(b, a, end, start);
      return;
    }
    const GreatCircleEdge between = edge(a, b);
    const auto [from, to] = between.arc().between(start.direction, end.direction);
    drawing_->draw(between, {from, start.node, start.position}, {to, end.node, end.position},
                   place(a), place(b));
  }

  std::shared_ptr<const SphereTessellation> sphere_;
  double tolerance_;
  LongitudeTurn longitudes_;
  Diagram diagram_;
  std::optional<EdgeDrawing> drawing_;
  std::vector<Vertex> centres_;         // by vertex
  std::optional<DisjointSets> groups_;  // of vertices
};

}  // namespace

Diagram sphere_diagram(std::span<const Point> places, const Box& frame, double tolerance) {
  return SphereDiagramBuilder(places, frame, tolerance).build();
}

}  // namespace thiessen
