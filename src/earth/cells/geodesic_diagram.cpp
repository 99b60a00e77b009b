#include "earth/cells/geodesic_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "earth/cells/cell_mesh.h"
#include "earth/cells/edge_drawing.h"
#include "earth/cells/equidistance.h"
#include "earth/cells/geodesic_vertices.h"
#include "earth/cells/longitude_turn.h"
#include "earth/sphere/geodesic.h"
#include "earth/sphere/sphere_tessellation.h"
#include "earth/sphere/units.h"
#include "geometry/insertion_order.h"

namespace thiessen {
namespace {

constexpr double pi = std::numbers::pi;

class GeodesicDiagramBuilder {
 public:
  GeodesicDiagramBuilder(std::span<const Point> places, const Box& frame, double tolerance,
                         double accuracy, unsigned threads, Neighbours neighbours)
      : sphere_(std::make_shared<SphereTessellation>(places)),
        tolerance_(tolerance),
        accuracy_(accuracy),
        threads_(threads),
        neighbours_(neighbours) {
    diagram_.frame = frame;
    diagram_.period = 360;
    diagram_.places.assign(places.begin(), places.end());
    diagram_.cell_of = sphere_->cell_of();
    diagram_.near = [sphere = sphere_](Point p) {
      return sphere->cell_of()[index(sphere->nearest_on_earth(p))];
    };
  }

  Diagram build() && {
    const Span span = sphere_->tessellation().span();
    if (span == Span::point) add_closed_edge();
    if (span == Span::line || span == Span::plane) add_edges();
    if (neighbours_ == Neighbours::left_out) {
      diagram_.neighbours.clear();
      return std::move(diagram_);
    }
    for (std::uint32_t p = 0; p < diagram_.places.size(); ++p) {
      const PlaceIndex cell = diagram_.cell_of[p];
      if (index(cell) != p) diagram_.neighbours.emplace_back(cell, PlaceIndex{p});
    }
    return std::move(diagram_);
  }

 private:
  Point position(PlaceIndex p) const { return diagram_.places[index(p)]; }

  // Two places share a single edge that closes on itself.
  void add_closed_edge() {
    const PlaceIndex first = sphere_->pole();
    const PlaceIndex second = sphere_->place(sphere_->tessellation().along_line().front());
    diagram_.neighbours.emplace_back(first, second);
    const GeodesicBisector edge(EarthPoint(position(first)), EarthPoint(position(second)),
                                sphere_->bisector(first, second), accuracy_);
    const Point start = LongitudeTurn(diagram_.frame).within(edge.find(pi).position);
    diagram_.nodes.push_back(start);
    EdgeDrawing drawing(diagram_.frame, tolerance_, 1);
    drawing.draw(edge, {-pi, 0, start}, {pi, 0, start}, first, second);
    drawing.add_to(diagram_);
    LongitudeTurn(diagram_.frame).draw_on_both_sides(diagram_);
  }

  void add_edges() {
    GeodesicVertices vertices(*sphere_, diagram_.places, diagram_.frame, accuracy_, threads_);
    const LongitudeTurn longitudes(diagram_.frame);
    const CellMesh& mesh = vertices.mesh();
    std::vector<std::uint32_t> node(mesh.triangles(), no_node);
    for (std::uint32_t t = 0; t < mesh.triangles(); ++t) {
      const std::uint32_t group = vertices.group_of(t);
      if (node[group] == no_node) {
        node[group] = static_cast<std::uint32_t>(diagram_.nodes.size());
        diagram_.nodes.push_back(longitudes.within(vertices.position(group)));
      }
      node[t] = node[group];
    }
    draw(vertices, node);
    longitudes.draw_on_both_sides(diagram_);
    if (neighbours_ == Neighbours::left_out) return;
    vertices.for_each_neighbours(
        [this](PlaceIndex a, PlaceIndex b) { diagram_.neighbours.emplace_back(a, b); });
  }

  // Sides are drawn in pieces of a fixed length, so that the nodes' numbers do not depend on the
  // number of threads.
  void draw(const GeodesicVertices& vertices, const std::vector<std::uint32_t>& node) {
    constexpr std::uint32_t sides_a_piece = 3000;
    const CellMesh& mesh = vertices.mesh();
    const auto vertex_nodes = static_cast<std::uint32_t>(diagram_.nodes.size());
    const std::size_t pieces = (mesh.sides() + sides_a_piece - 1) / sides_a_piece;
    std::vector<EdgeDrawing> drawings(pieces,
                                      EdgeDrawing(diagram_.frame, tolerance_, vertex_nodes));
    in_parallel(pieces, threads_, [&](std::size_t, std::size_t piece) {
      const auto first = static_cast<std::uint32_t>(piece * sides_a_piece);
      const std::uint32_t end = std::min(mesh.sides(), first + sides_a_piece);
      mesh.for_each_edge(first, end,
                         [&](SideIndex s) { draw_edge(vertices, node, s, drawings[piece]); });
    });
    std::size_t nodes = diagram_.nodes.size();
    std::size_t chords = 0;
    for (const EdgeDrawing& drawing : drawings) {
      nodes += drawing.nodes();
      chords += drawing.chords();
    }
    diagram_.nodes.reserve(nodes);
    diagram_.chords.reserve(chords);
    diagram_.bulges.reserve(chords);
    for (const EdgeDrawing& drawing : drawings) drawing.add_to(diagram_);
  }

  void draw_edge(const GeodesicVertices& vertices, const std::vector<std::uint32_t>& node,
                 SideIndex s, EdgeDrawing& drawing) const {
    const auto border = vertices.border(s);
    if (!border) return;
    const auto& [left, right, start, end] = *border;
    EdgePoint from{0, node[start], diagram_.nodes[node[start]]};
    EdgePoint to{0, node[end], diagram_.nodes[node[end]]};
    // What lies between is told by ends that are on the edge.
    if (vertices.is_exact(start) && vertices.is_exact(end) &&
        drawing.may_be_short(from.position, to.position)) {
      const auto short_edge = ShortEdge::fit(vertices.place(left), vertices.place(right),
                                             {from.position, vertices.direction(start)},
                                             {to.position, vertices.direction(end)});
      if (short_edge && drawing.draw_short(*short_edge, from, to, left, right)) return;
    }
    if (is_far(vertices.direction(start), vertices.direction(end), from.position)) return;
    const GeodesicBisector edge = vertices.edge(left, right);
    std::tie(from.angle, to.angle) = vertices.angles(edge, start, end);
    drawing.draw(edge, from, to, left, right);
  }

  // Whether an edge is short, and all of it is farther from the frame than it is long.
  bool is_far(Direction start, Direction end, Point start_position) const {
    constexpr double longest = 0.1;  // radians
    const double chord = length(end - start);
    return chord <= longest &&
           !may_come_near(diagram_.frame, start_position, 1.1 * chord / degree + 1e-3);
  }

  std::shared_ptr<const SphereTessellation> sphere_;
  double tolerance_;
  double accuracy_;
  unsigned threads_;
  Neighbours neighbours_;
  Diagram diagram_;
};

/// Gives the places of a diagram other numbers: `number` has that of each.
void renumber(Diagram& diagram, std::vector<std::uint32_t> number) {
  const auto renumbered = [&](PlaceIndex p) { return PlaceIndex{number[index(p)]}; };
  for (Chord& chord : diagram.chords) {
    throw_if_interrupted();
    chord.left = renumbered(chord.left);
    chord.right = renumbered(chord.right);
  }
  for (auto& [first, second] : diagram.neighbours) {
    first = renumbered(first);
    second = renumbered(second);
  }
  const std::vector<PlaceIndex> cell_of = diagram.cell_of;
  const std::vector<Point> places = diagram.places;
  for (std::size_t p = 0; p < number.size(); ++p) {
    diagram.cell_of[number[p]] = renumbered(cell_of[p]);
    diagram.places[number[p]] = places[p];
  }
  diagram.near = [near = std::move(diagram.near), number = std::move(number)](Point p) {
    return PlaceIndex{number[index(near(p))]};
  };
}

}  // namespace

// Many places are put in the order in which they lie, for in any other each look at a place's
// position would wait for the memory.
Diagram geodesic_diagram(std::span<const Point> places, const Box& frame, double tolerance,
                         double accuracy, unsigned threads, Neighbours neighbours) {
  constexpr std::size_t few = 1000;
  if (places.size() <= few)
    return GeodesicDiagramBuilder(places, frame, tolerance, accuracy, threads, neighbours).build();
  std::vector<std::uint32_t> order = insertion_order(places);
  std::vector<Point> ordered;
  ordered.reserve(places.size());
  for (const std::uint32_t p : order) ordered.push_back(places[p]);
  Diagram diagram =
      GeodesicDiagramBuilder(ordered, frame, tolerance, accuracy, threads, neighbours).build();
  renumber(diagram, std::move(order));
  return diagram;
}

}  // namespace thiessen
