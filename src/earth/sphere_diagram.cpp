#include "earth/sphere_diagram.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
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
        add_edges();
        break;
    }
    return std::move(diagram_);
  }

 private:
  const Tessellation& tessellation() const { return sphere_->tessellation(); }
  PlaceIndex place(PointId p) const { return sphere_->place(p); }
  Direction direction(PointId p) const { return sphere_->direction(place(p)); }
  Point position(PointId p) const { return diagram_.places[index(place(p))]; }

  // From a to b: the difference of nearby directions would be rounded away.
  Direction chord(PointId a, PointId b) const {
    const Direction difference = direction(b) - direction(a);
    constexpr double near = 1e-4;
    return dot(difference, difference) > near * near ? difference
                                                     : chord_on_sphere(position(a), position(b));
  }
  BisectorArc bisector(PointId a, PointId b) const {
    return {direction(a), direction(b), chord(a, b)};
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
  // circle counter-clockwise as seen from `centre`, that is the left one.
  void add_half_circles() {
    std::vector<PointId> ring = tessellation().along_line();
    ring.push_back(infinite_point);
    if (position(ring[ring.size() - 2]) < position(ring[0]))
      std::reverse(ring.begin(), ring.end() - 1);
    const Direction centre = unit(cross(chord(ring[0], ring[1]), chord(ring[0], ring.back())));
    const Vertex left = vertex_at(centre);
    const Vertex right = vertex_at(-1.0 * centre);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      add_edge(ring[i], ring[(i + 1) % ring.size()], right, left);
    }
  }

  void add_edges() {
    const Topology<2>& topology = tessellation().topology();
    std::vector<Vertex> vertices;
    vertices.reserve(topology.size());
    for (std::uint32_t i = 0; i < topology.size(); ++i)
      vertices.push_back(vertex_at(centre_of(VertexId{i})));
    for (std::uint32_t i = 0; i < topology.size(); ++i) {
      const VertexId v{i};
      for (std::size_t side = 0; side < 3; ++side) {
        const VertexId w = topology.neighbour(v, side);
        if (index(w) < i) continue;
        const auto& forming = topology.forming(v);
        add_edge(forming[(side + 1) % 3], forming[(side + 2) % 3], vertices[index(w)], vertices[i]);
      }
    }
  }

  // From the first forming point by coordinates on, so that rounding is the same for any order of
  // places.
  Direction centre_of(VertexId v) const {
    auto forming = tessellation().topology().forming(v);
    const auto first = std::min_element(forming.begin(), forming.end(), [&](PointId a, PointId b) {
      return position(a) < position(b);
    });
    std::rotate(forming.begin(), first, forming.end());
    return unit(cross(chord(forming[0], forming[1]), chord(forming[0], forming[2])));
  }

  struct Vertex {
    Direction direction;
    Point position;
    std::uint32_t node;
  };
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
};

}  // namespace

Diagram sphere_diagram(std::span<const Point> places, const Box& frame, double tolerance) {
  return SphereDiagramBuilder(places, frame, tolerance).build();
}

}  // namespace thiessen
